// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/geometry_pass.hpp"

#include <algorithm>

namespace polylume {

GeometryPass::GeometryPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const GpuScene& scene, const GBuffer& gbuffer)
    : gl_(gl), scene_(scene), programs_(gl, library, "passes/gbuffer.frag", gbuffer.defines()) {
    const std::vector<scene::Instance>& instances = scene_.scene().instances;
    for (int i = 0; i < static_cast<int>(instances.size()); ++i) {
        const scene::Material& material = scene_.materialOf(instances[static_cast<std::size_t>(i)]);
        if (material.alphaMode == scene::AlphaMode::blend) continue;
        order_.push_back(i);
        if (materialVariant(material) == 0) hasPlain_ = true;
    }
    std::ranges::stable_sort(order_, {}, [&](int i) {
        const scene::Material& material = scene_.materialOf(instances[static_cast<std::size_t>(i)]);
        return std::pair(materialVariant(material), &material);
    });
}

void GeometryPass::draw() {
    scene_.beginDrawing();
    gl_.Disable(GL_BLEND);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_TRUE);
    for (const int i : order_) {
        const scene::Instance& instance = scene_.scene().instances[static_cast<std::size_t>(i)];
        const GpuMesh& mesh = scene_.mesh(instance.mesh);
        const gl::Program& program = programs_.get(materialVariant(scene_.materialOf(instance)));
        program.use();
        scene_.bindMaterial(
            scene_.scene().meshes[static_cast<std::size_t>(instance.mesh)].material);
        scene_.bindInstance(i);
        gl_.BindVertexArray(mesh.vertexArray().name());
        program.drawElements(GL_TRIANGLES, mesh.indexCount(), 0);
    }
}

const gl::Program* GeometryPass::plainProgram() {
    return hasPlain_ ? &programs_.get(0) : nullptr;
}

}  // namespace polylume
