// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/light_outline.hpp"

#include <numbers>

namespace polylume {

glm::dvec3 areaVector(const std::vector<glm::vec3>& contour) {
    // Newell's method, with differences to the first vertex, so that a contour far from the origin
    // loses nothing.
    glm::dvec3 sum(0.0);
    const glm::dvec3 origin(contour.front());
    for (std::size_t i = 2; i < contour.size(); ++i) {
        sum += glm::cross(glm::dvec3(contour[i - 1]) - origin, glm::dvec3(contour[i]) - origin);
    }
    return sum;
}

std::vector<glm::vec3> outline(const EllipseLight& light, int sides) {
    // n/2 R^2 sin(2 pi/n) = pi, the area of the unit disk.
    const double step = 2.0 * std::numbers::pi / sides;
    const double radius = std::sqrt(2.0 * std::numbers::pi / (sides * std::sin(step)));
    std::vector<glm::vec3> contour;
    for (int i = 0; i < sides; ++i) {
        const auto x = static_cast<float>(radius * std::cos(step * i));
        const auto y = static_cast<float>(radius * std::sin(step * i));
        contour.push_back(light.center + (x * light.halfAxisX + y * light.halfAxisY));
    }
    return contour;
}

}  // namespace polylume
