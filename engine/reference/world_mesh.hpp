// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/scene.hpp"

namespace polylume::reference {

/// An instance in world space, transformed vertex by vertex as glsl/passes/mesh.vert does it.
struct WorldMesh {
    const scene::Mesh* mesh = nullptr;
    const scene::Material* material = nullptr;
    /// With one more at the end: Embree reads vertices by 16 bytes.
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;   ///< Unit.
    std::vector<glm::vec4> tangents;  ///< w: sign of the bitangent.
    bool isMirrored = false;          ///< Front faces turn clockwise.

    /// The three vertices of a triangle.
    glm::uvec3 triangle(unsigned index) const {
        const std::uint32_t* first = mesh->indices.data() + 3 * static_cast<std::size_t>(index);
        return {first[0], first[1], first[2]};
    }
    /// Perpendicular to a triangle, to its front, as long as twice its area.
    glm::dvec3 frontNormal(unsigned index) const;
};

WorldMesh makeWorldMesh(const scene::Scene& scene, const scene::Instance& instance);

}  // namespace polylume::reference
