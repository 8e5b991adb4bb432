// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/scene.hpp"

#include <algorithm>

namespace polylume::scene {

Bounds Scene::bounds() const {
    Bounds bounds;
    for (const Instance& instance : instances) {
        const Mesh& mesh = meshes[instance.mesh];
        for (const glm::vec3& position : mesh.positions) {
            bounds.include(glm::vec3(instance.worldFromObject * glm::vec4(position, 1.0f)));
        }
    }
    return bounds;
}

bool Scene::hasSheen() const {
    return std::ranges::any_of(materials, [](const Material& material) {
        return material.sheenColorFactor != glm::vec3(0.0f);
    });
}

}  // namespace polylume::scene
