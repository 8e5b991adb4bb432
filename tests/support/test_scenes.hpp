// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "scene/scene.hpp"

// Small scenes that tests and benchmarks share.
namespace polylume::test {

/// A camera at `eye` looking at `target`.
inline scene::Camera makeCamera(const glm::vec3& eye, const glm::vec3& target,
                                float yFovRadians = 0.8f) {
    const glm::vec3 up =
        std::abs(glm::normalize(target - eye).y) > 0.99f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
    scene::Camera camera;
    camera.worldFromCamera = glm::inverse(glm::lookAt(eye, target, up));
    scene::Perspective lens;
    lens.yFovRadians = yFovRadians;
    camera.projection = lens;
    return camera;
}

/// A square in the plane y = 0 around the origin, facing up.
inline scene::Mesh makeFloor(float halfSize) {
    scene::Mesh mesh;
    mesh.positions = {{-halfSize, 0, halfSize},
                      {halfSize, 0, halfSize},
                      {halfSize, 0, -halfSize},
                      {-halfSize, 0, -halfSize}};
    mesh.normals.assign(4, {0, 1, 0});
    mesh.tangents.assign(4, {1, 0, 0, 1});
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// A sphere of radius 1 around the origin.
inline scene::Mesh makeSphere(int rings = 48) {
    scene::Mesh mesh;
    const int segments = 2 * rings;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment <= segments; ++segment) {
            const float theta = 3.14159265f * static_cast<float>(ring) / static_cast<float>(rings);
            const float phi =
                6.28318531f * static_cast<float>(segment) / static_cast<float>(segments);
            const glm::vec3 p(std::sin(theta) * std::sin(phi), std::cos(theta),
                              std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(p);
            mesh.normals.push_back(p);
            mesh.tangents.emplace_back(std::cos(phi), 0, -std::sin(phi), 1);
        }
    }
    const auto vertex = [&](int ring, int segment) {
        return static_cast<std::uint32_t>(ring * (segments + 1) + segment);
    };
    for (int ring = 0; ring < rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            mesh.indices.insert(
                mesh.indices.end(),
                {vertex(ring, segment), vertex(ring + 1, segment), vertex(ring + 1, segment + 1)});
            mesh.indices.insert(
                mesh.indices.end(),
                {vertex(ring, segment), vertex(ring + 1, segment + 1), vertex(ring, segment + 1)});
        }
    }
    return mesh;
}

/// One instance of `mesh`, of one material.
inline scene::Scene makeScene(scene::Mesh mesh, float roughness, float metallic,
                              const glm::vec3& color) {
    scene::Scene scene;
    scene::Material material;
    material.baseColorFactor = glm::vec4(color, 1.0f);
    material.roughnessFactor = roughness;
    material.metallicFactor = metallic;
    scene.name = "test";
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.emplace_back();
    return scene;
}

}  // namespace polylume::test
