// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/emitter_pass.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

#include "lights/plane_axes.hpp"

namespace polylume {
namespace {

constexpr int kRectangleVertexCount = 4;  // A strip.
constexpr int kBoxVertexCount = 36;       // Triangles.

shared::EmitterData emitterOf(const shared::ParallelogramData& light) {
    shared::EmitterData data{};
    data.corner = light.corner;
    data.edgeX = light.edgeX;
    data.edgeY = light.edgeY;
    data.normal = light.normal;
    data.radiance = glm::vec4(glm::vec3(light.radiance), light.corner.w);
    data.vertices.z = shared::kWholeOutline;
    return data;
}

shared::EmitterData emitterOf(const shared::PolygonData& light,
                              const std::vector<glm::vec4>& vertices) {
    const glm::vec3 normal(light.plane);
    const PlaneAxes plane(normal);
    const glm::mat2x3 axes(plane.x, plane.y);
    const glm::vec3 origin(vertices[light.vertices.x]);
    glm::vec2 low(std::numeric_limits<float>::max());
    glm::vec2 high(std::numeric_limits<float>::lowest());
    for (std::uint32_t i = 0; i < light.vertices.y; ++i) {
        const glm::vec2 p = (glm::vec3(vertices[light.vertices.x + i]) - origin) * axes;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    shared::EmitterData data{};
    data.corner = glm::vec4(origin + axes * low, 0.0f);
    data.edgeX = glm::vec4((high.x - low.x) * axes[0], 0.0f);
    data.edgeY = glm::vec4((high.y - low.y) * axes[1], 0.0f);
    data.normal = glm::vec4(normal, 0.0f);
    data.radiance = light.radiance;
    data.vertices = {light.vertices.x, light.vertices.y, shared::kPolygonOutline, 0};
    return data;
}

shared::EmitterData emitterOf(const shared::EllipseData& light) {
    shared::EmitterData data{};
    data.corner = light.center - light.halfAxisX - light.halfAxisY;
    data.edgeX = 2.0f * light.halfAxisX;
    data.edgeY = 2.0f * light.halfAxisY;
    data.normal = light.normal;
    data.radiance = glm::vec4(glm::vec3(light.radiance), light.center.w);
    data.vertices.z = shared::kEllipseOutline;
    return data;
}

/// All points within `radius` of the line from `start` to `start` + `axis`.
shared::EmitterData makeSolid(const glm::vec3& start, const glm::vec3& axis, float radius,
                              const glm::vec4& radiance) {
    // The box is a little larger, so that rounding cuts off nothing.
    const float reach = 1.0001f * radius + 1e-6f * (glm::length(start) + glm::length(axis));
    const float length = glm::length(axis);
    const glm::vec3 x = length > 0.0f ? axis / length : glm::vec3(1.0f, 0.0f, 0.0f);
    const PlaneAxes across(x);
    shared::EmitterData data{};
    data.corner = glm::vec4(start - reach * (x + across.x + across.y), 0.0f);
    data.edgeX = glm::vec4((length + 2.0f * reach) * x, 0.0f);
    data.edgeY = glm::vec4(2.0f * reach * across.x, 0.0f);
    data.edgeZ = glm::vec4(2.0f * reach * across.y, 0.0f);
    data.radiance = radiance;
    data.start = glm::vec4(start, radius);
    data.axis = glm::vec4(axis, 0.0f);
    return data;
}

/// Leaves out what a surface in its place shows already (PolygonLight::shownBySurface).
std::vector<shared::EmitterData> packFlat(const PackedLights& lights) {
    std::vector<shared::EmitterData> emitters;
    // The last ones of each have an image.
    const std::size_t plainParallelogramCount =
        lights.parallelograms.size() - lights.texturedParallelogramCount;
    for (std::size_t i = 0; i < lights.parallelograms.size(); ++i) {
        const shared::ParallelogramData& light = lights.parallelograms[i];
        if (light.edgeY.w != 0.0f) continue;
        shared::EmitterData& emitter = emitters.emplace_back(emitterOf(light));
        if (i < plainParallelogramCount) continue;
        emitter.vertices.w = shared::kParallelogramImage;
        emitter.image = {light.normal.w, light.edgeX.w, light.radiance.w, 0.0f};
    }
    const std::size_t plainPolygonCount = lights.polygons.size() - lights.texturedPolygonCount;
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        const shared::PolygonData& light = lights.polygons[i];
        if (light.vertices.w != 0) continue;
        shared::EmitterData& emitter =
            emitters.emplace_back(emitterOf(light, lights.polygonVertices));
        if (i < plainPolygonCount) continue;
        emitter.vertices.w = shared::kPolygonImage;
        emitter.image.x = static_cast<float>(i - plainPolygonCount);
    }
    for (const auto& light : lights.ellipses) emitters.push_back(emitterOf(light));
    return emitters;
}

std::vector<shared::EmitterData> packSolid(const PackedLights& lights) {
    std::vector<shared::EmitterData> emitters;
    for (const shared::SphereData& light : lights.spheres) {
        emitters.push_back(
            makeSolid(glm::vec3(light.center), glm::vec3(0.0f), light.center.w, light.radiance));
    }
    for (const shared::TubeData& light : lights.tubes) {
        emitters.push_back(makeSolid(glm::vec3(light.start), glm::vec3(light.axis), light.start.w,
                                     light.radiance));
    }
    return emitters;
}

}  // namespace

EmitterPass::EmitterPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                         const LightingPass& lighting, GeometryPass* geometry)
    : gl_(gl),
      library_(library),
      lighting_(lighting),
      geometry_(geometry),
      noVertices_(gl, "emitters, no vertices") {
    updateLights();
}

void EmitterPass::updateLights() {
    std::vector<shared::EmitterData> others = packFlat(lighting_.packedLights());
    std::vector<shared::EmitterData> plain;
    if (geometry_ != nullptr && geometry_->plainProgram() != nullptr) {
        std::ranges::copy_if(others, std::back_inserter(plain), isPlain);
        std::erase_if(others, isPlain);
    }
    PlainEmitters plainEmitters(gl_, plain);
    Batch flat =
        makeBatch(others, flat_, "flat emitters", "passes/emitter.vert", "passes/emitter.frag");
    Batch solid = makeBatch(packSolid(lighting_.packedLights()), solid_, "solid emitters",
                            "passes/emitter_solid.vert", "passes/emitter_solid.frag");
    plain_ = std::move(plainEmitters);
    flat_ = std::move(flat);
    solid_ = std::move(solid);
}

EmitterPass::Batch EmitterPass::makeBatch(const std::vector<shared::EmitterData>& emitters,
                                          const Batch& old, const char* label,
                                          const char* vertexPath, const char* fragmentPath) const {
    Batch batch;
    batch.count = static_cast<int>(emitters.size());
    batch.program = old.program;
    batch.defines = old.defines;
    if (emitters.empty()) return batch;
    batch.emitters = BlockArray(gl_, emitters, label);
    if (batch.program == nullptr || batch.defines != lighting_.defines()) {
        batch.defines = lighting_.defines();
        batch.program = std::make_shared<gl::Program>(gl_, library_, vertexPath, fragmentPath,
                                                      batch.defines, label);
    }
    return batch;
}

void EmitterPass::draw() const {
    if (plain_.isEmpty() && flat_.count + solid_.count == 0) return;
    lighting_.bind();
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.Disable(GL_BLEND);
    gl_.FrontFace(GL_CCW);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.DepthMask(GL_TRUE);
    if (!plain_.isEmpty()) plain_.draw(*geometry_->plainProgram());

    gl_.Disable(GL_CULL_FACE);
    gl_.BindVertexArray(noVertices_.name());
    draw(flat_, GL_TRIANGLE_STRIP, kRectangleVertexCount);

    // A box by its far faces: each of its pixels once, also where the camera is inside; and whole,
    // where they lie beyond what the camera sees.
    gl_.Enable(GL_CULL_FACE);
    gl_.CullFace(GL_FRONT);
    gl_.Enable(GL_DEPTH_CLAMP);
    draw(solid_, GL_TRIANGLES, kBoxVertexCount);
    gl_.Disable(GL_DEPTH_CLAMP);
    gl_.Disable(GL_CULL_FACE);
}

void EmitterPass::draw(const Batch& batch, GLenum mode, int vertexCount) const {
    if (batch.count == 0) return;
    batch.program->use();
    for (int i = 0; i < batch.count; ++i) {
        batch.emitters.bind(shared::kEmitterBinding, i);
        batch.program->drawArrays(mode, 0, vertexCount);
    }
}

}  // namespace polylume
