// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light.hpp"

#include <numbers>

namespace polylume::scene {

std::vector<glm::vec3> outline(const AreaLight& light, int diskSides) {
    std::vector<glm::vec2> corners;
    if (light.shape == AreaLightShape::rectangle) {
        corners = {{-0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}};
    } else {
        // n/2 R^2 sin(2 pi/n) = pi/4, the area of a disk of diameter 1.
        const double step = 2.0 * std::numbers::pi / diskSides;
        const double radius = std::sqrt(std::numbers::pi / (2.0 * diskSides * std::sin(step)));
        for (int i = 0; i < diskSides; ++i) {
            corners.emplace_back(radius * std::cos(-step * i), radius * std::sin(-step * i));
        }
    }
    // Clockwise around +Z is counter-clockwise seen from the emitting side, -Z.
    std::vector<glm::vec3> contour;
    for (const glm::vec2& corner : corners) {
        contour.push_back(light.center +
                          light.worldFromLight * glm::vec3(corner * light.size, 0.0f));
    }
    return contour;
}

}  // namespace polylume::scene
