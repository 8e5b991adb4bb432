// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_pass.hpp"

#include <utility>

namespace polylume {

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const ltc::Table& table)
    : gl_(gl), library_(library), noVertices_(gl, "lighting, no vertices") {
    uploadTable(table);
    setLights({});
}

void LightingPass::setLights(const LightSet& lights) {
    packed_ = packLights(lights);
    parallelograms_ =
        gl::Buffer(gl_, gl::bytesOf(packed_.parallelograms), 0, "parallelogram lights");
    polygons_ = gl::Buffer(gl_, gl::bytesOf(packed_.polygons), 0, "polygon lights");
    polygonVertices_ =
        gl::Buffer(gl_, gl::bytesOf(packed_.polygonVertices), 0, "polygon light vertices");
    punctuals_ = gl::Buffer(gl_, gl::bytesOf(packed_.punctuals), 0, "punctual lights");
    uploadSettings();

    std::vector<std::string> defines;
    if (!packed_.polygons.empty()) defines.emplace_back("POLYLUME_POLYGON_LIGHTS");
    if (!packed_.punctuals.empty()) defines.emplace_back("POLYLUME_PUNCTUAL_LIGHTS");
    if (program_.isEmpty() || defines != defines_) {
        defines_ = std::move(defines);
        program_ = gl::Program(gl_, library_, "passes/fullscreen.vert", "passes/lighting.frag",
                               defines_, "lighting");
    }
}

void LightingPass::setLobes(Lobes lobes) {
    lobes_ = lobes;
    uploadSettings();
}

void LightingPass::draw(const GBufferTextures& gbuffer) const {
    bind();
    gl_.BindTextures(0, static_cast<GLsizei>(gbuffer.size()), gbuffer.data());
    for (GLuint unit = 0; unit < gbuffer.size(); ++unit) gl_.BindSampler(unit, 0);
    program_.use();
    gl_.BindVertexArray(noVertices_.name());
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                                    GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP}) {
        gl_.Disable(capability);
    }
    // The triangle lies at the far plane of reversed depth: a surface is whatever is nearer, the
    // background is passed over.
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthMask(GL_FALSE);
    // The depth texture is read while it is attached: what was written before has to be seen
    // (OpenGL 4.5, 9.3.1).
    gl_.TextureBarrier();
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void LightingPass::bind() const {
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kLightingBinding, settings_.name());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, shared::kParallelogramBinding,
                       parallelograms_.name());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, shared::kPolygonBinding, polygons_.name());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, shared::kPolygonVertexBinding,
                       polygonVertices_.name());
    gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, shared::kPunctualBinding, punctuals_.name());
    gl_.BindTextureUnit(shared::kTableMatricesUnit, tableMatrices_.name());
    gl_.BindTextureUnit(shared::kTableAlbedosUnit, tableAlbedos_.name());
    gl_.BindSampler(shared::kTableMatricesUnit, 0);
    gl_.BindSampler(shared::kTableAlbedosUnit, 0);
}

void LightingPass::uploadTable(const ltc::Table& table) {
    std::vector<glm::vec4> matrices;
    std::vector<glm::vec2> albedos;
    const std::span<const float> values = table.values();
    for (std::size_t i = 0; i < values.size(); i += ltc::Table::kValueCount) {
        matrices.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
        albedos.emplace_back(values[i + 4], values[i + 5]);
    }
    const glm::ivec2 size(table.size());
    tableMatrices_ = gl::Texture(gl_, GL_RGBA32F, size, 1, "LTC table, matrices");
    tableMatrices_.upload(GL_RGBA, GL_FLOAT, matrices.data());
    tableAlbedos_ = gl::Texture(gl_, GL_RG32F, size, 1, "LTC table, albedos");
    tableAlbedos_.upload(GL_RG, GL_FLOAT, albedos.data());
}

void LightingPass::uploadSettings() {
    shared::LightingData data{};
    data.lightCount = {packed_.parallelograms.size(), packed_.polygons.size(),
                       packed_.punctuals.size(), 0};
    data.lobeWeight = {lobes_ != Lobes::specular, lobes_ != Lobes::diffuse, lobes_ == Lobes::all,
                       0};
    settings_ = gl::Buffer(gl_, gl::bytesOf(data), 0, "lighting settings");
}

}  // namespace polylume
