// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/emitter_pass.hpp"

#include <limits>

namespace polylume {
namespace {

shared::EmitterData emitterOf(const shared::ParallelogramData& light) {
    shared::EmitterData data{};
    data.corner = light.corner;
    data.edgeX = light.edgeX;
    data.edgeY = light.edgeY;
    data.normal = light.normal;
    data.radiance = glm::vec4(glm::vec3(light.radiance), light.corner.w);
    return data;
}

shared::EmitterData emitterOf(const shared::PolygonData& light,
                              const std::vector<glm::vec4>& vertices) {
    const glm::vec3 normal(light.plane);
    const glm::vec3 helper = std::abs(normal.x) < 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    const glm::vec3 x = glm::normalize(glm::cross(helper, normal));
    const glm::vec3 y = glm::cross(normal, x);
    const glm::vec3 origin(vertices[light.vertices.x]);
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(std::numeric_limits<float>::lowest());
    for (std::uint32_t i = 0; i < light.vertices.y; ++i) {
        const glm::vec3 offset = glm::vec3(vertices[light.vertices.x + i]) - origin;
        const glm::vec2 p(glm::dot(offset, x), glm::dot(offset, y));
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    shared::EmitterData data{};
    data.corner = glm::vec4(origin + low.x * x + low.y * y, 0.0f);
    data.edgeX = glm::vec4((high.x - low.x) * x, 0.0f);
    data.edgeY = glm::vec4((high.y - low.y) * y, 0.0f);
    data.normal = glm::vec4(normal, 0.0f);
    data.radiance = light.radiance;
    data.vertices = light.vertices;
    return data;
}

std::vector<shared::EmitterData> packEmitters(const PackedLights& lights) {
    std::vector<shared::EmitterData> emitters;
    for (const auto& light : lights.parallelograms) emitters.push_back(emitterOf(light));
    for (const auto& light : lights.polygons) {
        emitters.push_back(emitterOf(light, lights.polygonVertices));
    }
    return emitters;
}

}  // namespace

EmitterPass::EmitterPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                         const LightingPass& lighting)
    : gl_(gl), lighting_(lighting), noVertices_(gl, "emitters, no vertices") {
    const std::vector<shared::EmitterData> emitters = packEmitters(lighting.packedLights());
    emitterCount_ = static_cast<int>(emitters.size());
    if (emitters.empty()) return;
    program_ = gl::Program(gl, library, "passes/emitter.vert", "passes/emitter.frag",
                           lighting.defines(), "emitters");
    emitters_ = BlockArray(gl, emitters, "emitters");
}

void EmitterPass::draw() const {
    if (emitterCount_ == 0) return;
    lighting_.bind();
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.Disable(GL_BLEND);
    gl_.Disable(GL_CULL_FACE);
    gl_.FrontFace(GL_CCW);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_TRUE);
    program_.use();
    gl_.BindVertexArray(noVertices_.name());
    for (int i = 0; i < emitterCount_; ++i) {
        emitters_.bind(shared::kEmitterBinding, i);
        gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

}  // namespace polylume
