// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/world_mesh.hpp"

#include <cmath>

#include "view/instance_transform.hpp"

namespace polylume::reference {
namespace {

glm::vec3 unit(const glm::vec3& v) {
    return v / std::sqrt(std::max(glm::dot(v, v), 1e-30f));
}

}  // namespace

glm::dvec3 WorldMesh::frontNormal(unsigned index) const {
    const glm::uvec3 t = triangle(index);
    const glm::dvec3 a(positions[t.x]);
    const glm::dvec3 normal =
        glm::cross(glm::dvec3(positions[t.y]) - a, glm::dvec3(positions[t.z]) - a);
    return isMirrored ? -normal : normal;
}

WorldMesh makeWorldMesh(const scene::Scene& scene, const scene::Instance& instance) {
    WorldMesh world;
    world.mesh = &scene.meshes[static_cast<std::size_t>(instance.mesh)];
    world.material = &scene.materials[static_cast<std::size_t>(world.mesh->material)];
    const shared::InstanceData data = makeInstanceData(instance);
    const glm::mat3 normalFromObject(data.normalFromObject);
    const glm::mat3 linear = glm::mat3(data.worldFromObject) * data.mirror.y;
    world.isMirrored = data.mirror.x < 0.0f;
    const std::size_t count = world.mesh->positions.size();
    world.positions.reserve(count + 1);
    world.normals.reserve(count);
    world.tangents.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3 normal = unit(normalFromObject * world.mesh->normals[i]);
        const glm::vec4& tangentObject = world.mesh->tangents[i];
        glm::vec3 tangent = linear * glm::vec3(tangentObject);
        // Non-uniform scale tilts a tangent; it has to stay in the surface.
        tangent -= normal * glm::dot(normal, tangent);
        world.positions.emplace_back(data.worldFromObject *
                                     glm::vec4(world.mesh->positions[i], 1.0f));
        world.normals.push_back(normal);
        world.tangents.emplace_back(unit(tangent), tangentObject.w * data.mirror.x);
    }
    world.positions.emplace_back(0.0f);
    return world;
}

}  // namespace polylume::reference
