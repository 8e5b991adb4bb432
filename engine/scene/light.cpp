// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light.hpp"

namespace polylume::scene {

std::vector<glm::vec3> corners(const AreaLight& light) {
    // Clockwise around +Z is counter-clockwise seen from the emitting side, -Z.
    std::vector<glm::vec3> contour;
    for (const glm::vec2& corner :
         {glm::vec2(-0.5f, -0.5f), {-0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}}) {
        contour.push_back(light.center +
                          light.worldFromLight * glm::vec3(corner * light.size, 0.0f));
    }
    return contour;
}

}  // namespace polylume::scene
