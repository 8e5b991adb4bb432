// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/blend_pass.hpp"

#include <algorithm>
#include <cstdint>

namespace polylume {
namespace {

constexpr const char* kFragmentPath = "passes/blend.frag";

struct SortedTriangle {
    float distance = 0.0f;
    int instance = 0;
    const std::uint32_t* indices = nullptr;
};

void gatherTriangles(const scene::Scene& scene, int instanceIndex, const scene::Camera& camera,
                     std::vector<SortedTriangle>& triangles) {
    const scene::Instance& instance = scene.instances[static_cast<std::size_t>(instanceIndex)];
    const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const glm::vec3 eye(camera.worldFromCamera[3]);
    const glm::vec3 forward(-camera.worldFromCamera[2]);
    const bool perspective = std::holds_alternative<scene::Perspective>(camera.projection);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* indices = &mesh.indices[i];
        const glm::vec3 sum =
            mesh.positions[indices[0]] + mesh.positions[indices[1]] + mesh.positions[indices[2]];
        const glm::vec3 offset =
            glm::vec3(instance.worldFromObject * glm::vec4(sum / 3.0f, 1.0f)) - eye;
        const float distance = perspective ? glm::length(offset) : glm::dot(offset, forward);
        triangles.push_back({distance, instanceIndex, indices});
    }
}

}  // namespace

BlendPass::BlendPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                     const GpuScene& scene, const LightingPass& lighting,
                     const scene::Camera& camera)
    : gl_(gl),
      library_(library),
      scene_(scene),
      lighting_(lighting),
      defines_(lighting.defines()),
      programs_(gl, library, kFragmentPath, defines_) {
    sortFor(camera);
}

void BlendPass::updateLights() {
    if (defines_ == lighting_.defines()) return;
    defines_ = lighting_.defines();
    programs_.setDefines(defines_);
}

void BlendPass::sortFor(const scene::Camera& camera) {
    runs_.clear();
    const std::vector<scene::Instance>& instances = scene_.scene().instances;
    std::vector<SortedTriangle> triangles;
    for (int i = 0; i < static_cast<int>(instances.size()); ++i) {
        const scene::Material& material = scene_.materialOf(instances[static_cast<std::size_t>(i)]);
        if (material.alphaMode == scene::AlphaMode::blend) {
            gatherTriangles(scene_.scene(), i, camera, triangles);
        }
    }
    if (triangles.empty()) return;
    std::ranges::stable_sort(triangles, std::ranges::greater{}, &SortedTriangle::distance);

    std::vector<std::uint32_t> indices;
    for (const SortedTriangle& triangle : triangles) {
        if (runs_.empty() || runs_.back().instance != triangle.instance) {
            runs_.push_back({triangle.instance, indices.size(), 0});
        }
        indices.insert(indices.end(), triangle.indices, triangle.indices + 3);
        runs_.back().indexCount += 3;
    }
    indices_ = gl::Buffer(gl_, gl::bytesOf(indices), 0, "sorted indices");
    vertexArrays_.clear();
    vertexArrays_.resize(instances.size());
    for (const Run& run : runs_) {
        gl::VertexArray& vertexArray = vertexArrays_[static_cast<std::size_t>(run.instance)];
        if (vertexArray.name() != 0) continue;
        const int mesh = instances[static_cast<std::size_t>(run.instance)].mesh;
        vertexArray = scene_.mesh(mesh).makeVertexArray(gl_, indices_);
    }
}

void BlendPass::draw() {
    if (runs_.empty()) return;
    lighting_.bind();
    scene_.beginDrawing();
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    // Colour over what is there; alpha as the coverage of both.
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const Run& run : runs_) {
        const scene::Instance& instance =
            scene_.scene().instances[static_cast<std::size_t>(run.instance)];
        const gl::Program& program = programs_.get(materialVariant(scene_.materialOf(instance)));
        program.use();
        scene_.bindMaterial(
            scene_.scene().meshes[static_cast<std::size_t>(instance.mesh)].material);
        scene_.bindInstance(run.instance);
        gl_.BindVertexArray(vertexArrays_[static_cast<std::size_t>(run.instance)].name());
        program.drawElements(GL_TRIANGLES, run.indexCount, run.firstIndex);
    }
}

}  // namespace polylume
