// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/plain_emitters.hpp"

#include "view/instance_transform.hpp"

namespace polylume {
namespace {

constexpr int kVertexCount = 4;  // A strip of two triangles.

/// It emits and reflects nothing, as glsl/surface/emitting_surface.glsl has it.
shared::MaterialData materialOf(const shared::EmitterData& emitter) {
    shared::MaterialData data{};
    data.baseColorFactor = {0.0f, 0.0f, 0.0f, 1.0f};
    data.emissiveFactor = emitter.radiance;
    data.roughnessFactor = 1.0f;
    return data;
}

}  // namespace

bool isPlain(const shared::EmitterData& emitter) {
    return emitter.vertices.z == shared::kWholeOutline && emitter.vertices.w == shared::kNoImage;
}

PlainEmitters::PlainEmitters(const gl::Functions& gl,
                             const std::vector<shared::EmitterData>& emitters)
    : gl_(&gl) {
    if (emitters.empty()) return;
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<shared::MaterialData> materials;
    for (const shared::EmitterData& emitter : emitters) {
        // In the order of passes/emitter.vert.
        for (int vertex = 0; vertex < kVertexCount; ++vertex) {
            const auto x = static_cast<float>(vertex & 1);
            const auto y = static_cast<float>(vertex >> 1);
            positions.emplace_back(emitter.corner + x * emitter.edgeX + y * emitter.edgeY);
            normals.emplace_back(emitter.normal);
        }
        materials.push_back(materialOf(emitter));
        twoSided_.push_back(emitter.radiance.w > 0.5f);
    }
    positions_ = gl::Buffer(gl, gl::bytesOf(positions), 0, "plain emitters, positions");
    normals_ = gl::Buffer(gl, gl::bytesOf(normals), 0, "plain emitters, normals");
    vertexArray_ = gl::VertexArray(gl, "plain emitters");
    vertexArray_.setFloats(0, 3, positions_, sizeof(glm::vec3));
    vertexArray_.setFloats(1, 3, normals_, sizeof(glm::vec3));
    materials_ = BlockArray(gl, materials, "plain emitters, materials");
    place_ = BlockArray(gl, std::vector{makeInstanceData({})}, "plain emitters, place");
}

void PlainEmitters::draw(const gl::Program& program) const {
    if (isEmpty()) return;
    program.use();
    gl_->VertexAttrib4f(5, 1.0f, 1.0f, 1.0f, 1.0f);
    gl_->BindVertexArray(vertexArray_.name());
    gl_->CullFace(GL_BACK);
    place_.bind(shared::kInstanceBinding, 0);
    for (int i = 0; i < static_cast<int>(twoSided_.size()); ++i) {
        if (twoSided_[static_cast<std::size_t>(i)]) {
            gl_->Disable(GL_CULL_FACE);
        } else {
            gl_->Enable(GL_CULL_FACE);
        }
        materials_.bind(shared::kMaterialBinding, i);
        program.drawArrays(GL_TRIANGLE_STRIP, kVertexCount * i, kVertexCount);
    }
}

}  // namespace polylume
