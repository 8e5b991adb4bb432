// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace polylume {

/// A unit vector at right angles to the vector `unit` of length 1.
template <typename Number>
glm::vec<3, Number> perpendicularTo(const glm::vec<3, Number>& unit) {
    using Vector = glm::vec<3, Number>;
    const Vector other = std::abs(unit.x) < Number(0.5) ? Vector(1, 0, 0) : Vector(0, 1, 0);
    return glm::normalize(glm::cross(other, unit));
}

/// Two unit vectors, x and y, that turn counter-clockwise seen from where the unit vector `normal`
/// points to.
template <typename Number>
struct PlaneAxes {
    explicit PlaneAxes(const glm::vec<3, Number>& normal)
        : x(perpendicularTo(normal)), y(glm::cross(normal, x)) {}

    glm::vec<3, Number> x, y;
};

}  // namespace polylume
