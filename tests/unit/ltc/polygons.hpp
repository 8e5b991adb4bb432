// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "ltc/polygon_integral.hpp"

// Polygons that the tests of this folder share. All face down (towards -z) unless said otherwise,
// so that the origin below them sees the emitting side.
namespace polylume::ltc::testing {

using Polygon = std::vector<Contour>;

/// The rectangle x0..x1 by y0..y1 at height z. Seen from below, counter-clockwise.
inline Polygon rectangle(double x0, double x1, double y0, double y1, double z) {
    return {{{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}}};
}

/// A regular polygon of the disk's area (or of its radius) about (x, 0, z).
inline Polygon disk(double x, double z, double radius, int sideCount, bool equalArea) {
    const double step = 2.0 * std::numbers::pi / sideCount;
    const double scale =
        equalArea ? std::sqrt(std::numbers::pi / (0.5 * sideCount * std::sin(step))) : 1.0;
    Contour contour;
    for (int i = 0; i < sideCount; ++i) {
        contour.emplace_back(x + scale * radius * std::cos(step * i),
                             -scale * radius * std::sin(step * i), z);
    }
    return {contour};
}

inline Polygon reversed(Polygon polygon) {
    for (Contour& contour : polygon) std::reverse(contour.begin(), contour.end());
    return polygon;
}

inline Polygon transformed(Polygon polygon, const glm::dmat3& matrix, const glm::dvec3& offset) {
    for (Contour& contour : polygon) {
        for (glm::dvec3& vertex : contour) vertex = matrix * vertex + offset;
    }
    return polygon;
}

/// Rotation about an axis by an angle in radians (Rodrigues).
inline glm::dmat3 rotation(const glm::dvec3& axis, double angle) {
    const glm::dvec3 u = glm::normalize(axis);
    glm::dmat3 matrix;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 basis(0.0);
        basis[i] = 1.0;
        matrix[i] = basis * std::cos(angle) + glm::cross(u, basis) * std::sin(angle) +
                    u * glm::dot(u, basis) * (1.0 - std::cos(angle));
    }
    return matrix;
}

/// An L-shaped hexagon at height z, concave, facing down.
inline Polygon concave(double z) {
    return reversed({{{-1, -1, z}, {2, -1, z}, {2, 0, z}, {0, 0, z}, {0, 2, z}, {-1, 2, z}}});
}

}  // namespace polylume::ltc::testing
