// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_pass.hpp"

#include <array>
#include <utility>

#include "ltc/builtin_table.hpp"

namespace polylume {
namespace {

const ltc::Table& specularTableOf(const LightingModel& model) {
    using ltc::BuiltinTable;
    const bool high = model.quality == Quality::high;
    const BuiltinTable ggx = high ? BuiltinTable::ggxTwoLobes : BuiltinTable::ggx;
    const BuiltinTable beckmann = high ? BuiltinTable::beckmannTwoLobes : BuiltinTable::beckmann;
    return ltc::builtinTable(model.specular == Specular::beckmann ? beckmann : ggx);
}

}  // namespace

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const LightingModel& model)
    : LightingPass(gl, library, specularTableOf(model), model) {}

LightingPass::LightingPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                           const ltc::Table& specularTable, const LightingModel& model)
    : gl_(gl),
      library_(library),
      model_(model),
      specularTable_(uploadTable(gl, specularTable, "specular table")),
      noVertices_(gl, "lighting, no vertices") {
    using ltc::BuiltinTable;
    if (model.diffuse != Diffuse::lambert) {
        const BuiltinTable diffuse =
            model.diffuse == Diffuse::burley ? BuiltinTable::burley : BuiltinTable::orenNayar;
        diffuseTable_ = uploadTable(gl, ltc::builtinTable(diffuse), "diffuse table");
    }
    if (model.sheen) {
        sheenTable_ = uploadTable(gl, ltc::builtinTable(BuiltinTable::charlie), "sheen table");
    }
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

    std::vector<std::string> defines = makeDefines();
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
    const std::array units = {std::pair(shared::kSpecularTableUnit, &specularTable_),
                              std::pair(shared::kDiffuseTableUnit, &diffuseTable_),
                              std::pair(shared::kSheenTableUnit, &sheenTable_)};
    for (const auto& [unit, table] : units) {
        gl_.BindTextureUnit(unit, table->texture.name());
        gl_.BindSampler(unit, 0);
    }
}

std::vector<std::string> LightingPass::makeDefines() const {
    std::vector<std::string> defines;
    const auto add = [&](bool condition, const char* name) {
        if (condition) defines.emplace_back(name);
    };
    add(!packed_.polygons.empty(), "POLYLUME_POLYGON_LIGHTS");
    add(!packed_.punctuals.empty(), "POLYLUME_PUNCTUAL_LIGHTS");
    add(specularTable_.lobeCount == 2, "POLYLUME_TWO_LOBES");
    add(model_.specular == Specular::beckmann, "POLYLUME_SPECULAR_BECKMANN");
    add(model_.diffuse == Diffuse::burley, "POLYLUME_DIFFUSE_BURLEY");
    add(model_.diffuse == Diffuse::orenNayar, "POLYLUME_DIFFUSE_OREN_NAYAR");
    add(model_.sheen, "POLYLUME_SHEEN");
    return defines;
}

void LightingPass::uploadSettings() {
    shared::LightingData data{};
    data.lightCount = {packed_.parallelograms.size(), packed_.polygons.size(),
                       packed_.punctuals.size(), 0};
    data.lobeWeight = {lobes_ != Lobes::specular, lobes_ != Lobes::diffuse, lobes_ == Lobes::all,
                       0};
    data.lobeReferences = glm::vec4(specularTable_.reference, diffuseTable_.reference);
    data.sheenReference = glm::vec4(sheenTable_.reference, 0.0f, 0.0f);
    settings_ = gl::Buffer(gl_, gl::bytesOf(data), 0, "lighting settings");
}

}  // namespace polylume
