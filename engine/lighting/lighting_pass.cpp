// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_pass.hpp"

#include <array>
#include <utility>

#include "core/text.hpp"
#include "lights/texture_check.hpp"
#include "ltc/builtin_table.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

const ltc::Table& specularTableOf(const LightingModel& model) {
    using ltc::BuiltinTable;
    const bool high = model.quality == Quality::high;
    const BuiltinTable ggx = high ? BuiltinTable::ggxTwoLobes : BuiltinTable::ggx;
    const BuiltinTable beckmann = high ? BuiltinTable::beckmannTwoLobes : BuiltinTable::beckmann;
    return ltc::builtinTable(model.specular == Specular::beckmann ? beckmann : ggx);
}

/// The shaders read the vertices of polygons as texels, of which a driver has a limit.
void checkVertexCount(const gl::Functions& gl, std::size_t count) {
    GLint most = 0;
    gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (count <= static_cast<std::size_t>(most)) return;
    throw Error(concat("expected all polygon lights together to have at most ", most,
                       " vertices, which is this driver's limit, found ", count,
                       ": leave out vertices or lights"));
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
    PackedLights packed = packLights(lights);
    checkVertexCount(gl_, packed.polygonVertices.size());
    if (!packed.texturedLights.empty() && !imagePrograms_) {
        imagePrograms_ = std::make_shared<LightImagePrograms>(gl_, library_);
    }
    LightTextureArray images(gl_, imagePrograms_, std::move(packed.texturedLights));
    packed_ = std::move(packed);
    lightImages_ = std::move(images);
    uploadLightTextures();
    parallelograms_ =
        gl::Buffer(gl_, gl::bytesOf(packed_.parallelograms), 0, "parallelogram lights");
    polygons_ = gl::Buffer(gl_, gl::bytesOf(packed_.polygons), 0, "polygon lights");
    polygonVertices_ =
        gl::Buffer(gl_, gl::bytesOf(packed_.polygonVertices), 0, "polygon light vertices");
    polygonVertexTexels_ =
        gl::BufferTexture(gl_, GL_RGBA32F, polygonVertices_, "polygon light vertices");
    punctuals_ = gl::Buffer(gl_, gl::bytesOf(packed_.punctuals), 0, "punctual lights");
    ellipses_ = gl::Buffer(gl_, gl::bytesOf(packed_.ellipses), 0, "ellipse lights");
    spheres_ = gl::Buffer(gl_, gl::bytesOf(packed_.spheres), 0, "sphere lights");
    tubes_ = gl::Buffer(gl_, gl::bytesOf(packed_.tubes), 0, "tube lights");
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
    const std::array storages = {std::pair(shared::kParallelogramBinding, &parallelograms_),
                                 std::pair(shared::kPolygonBinding, &polygons_),
                                 std::pair(shared::kPolygonVertexBinding, &polygonVertices_),
                                 std::pair(shared::kPunctualBinding, &punctuals_),
                                 std::pair(shared::kEllipseBinding, &ellipses_),
                                 std::pair(shared::kSphereBinding, &spheres_),
                                 std::pair(shared::kTubeBinding, &tubes_),
                                 std::pair(shared::kLightTextureBinding, &lightTextures_)};
    for (const auto& [binding, buffer] : storages) {
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer->name());
    }
    const std::array units = {std::pair(shared::kSpecularTableUnit, &specularTable_),
                              std::pair(shared::kDiffuseTableUnit, &diffuseTable_),
                              std::pair(shared::kSheenTableUnit, &sheenTable_)};
    gl_.BindTextureUnit(shared::kPolygonVertexUnit, polygonVertexTexels_.name());
    gl_.BindSampler(shared::kPolygonVertexUnit, 0);
    for (const auto& [unit, table] : units) {
        gl_.BindTextureUnit(unit, table->texture.name());
        gl_.BindSampler(unit, 0);
    }
    if (!lightImages_.lights().empty()) lightImages_.bind(shared::kLightImageUnit);
}

/// Tells the packed lights where their images are.
void LightingPass::uploadLightTextures() {
    const std::vector<TexturedLight>& lights = lightImages_.lights();
    const std::size_t first = packed_.parallelograms.size() - packed_.texturedParallelogramCount;
    std::vector<shared::LightTextureData> textures;
    for (std::size_t layer = 0; layer < lights.size(); ++layer) {
        const LightTextureFrame& frame = lights[layer].frame;
        const auto layerNumber = static_cast<float>(layer);
        const glm::vec2 texels(frame.size);
        if (layer < packed_.texturedParallelogramCount) {
            shared::ParallelogramData& data = packed_.parallelograms[first + layer];
            data.normal.w = layerNumber;
            data.edgeX.w = texels.x;
            data.radiance.w = texels.y;
            continue;
        }
        textures.push_back({glm::vec4(frame.corner, layerNumber), glm::vec4(frame.edgeX, texels.x),
                            glm::vec4(frame.edgeY, texels.y),
                            glm::vec4(frame.center, 1.0 / frame.variance)});
    }
    lightTextures_ = gl::Buffer(gl_, gl::bytesOf(textures), 0, "light textures");
}

std::size_t LightingPass::imageLayer(std::size_t polygon) const {
    const std::vector<TexturedLight>& lights = lightImages_.lights();
    for (std::size_t layer = 0; layer < lights.size(); ++layer) {
        if (lights[layer].polygon == polygon) return layer;
    }
    throw Error(concat("expected polygon light ", polygon,
                       " to have a texture and an area, found none; give it a texture in "
                       "setLights() first"));
}

void LightingPass::updateLightTexture(std::size_t polygon, GLuint texture) {
    lightImages_.update(imageLayer(polygon), texture);
}

void LightingPass::updateLightTexture(std::size_t polygon, const LightImage& image) {
    const std::size_t layer = imageLayer(polygon);
    checkLightImage(image, polygon);
    lightImages_.update(layer, image);
}

std::vector<std::string> LightingPass::makeDefines() const {
    std::vector<std::string> defines;
    const auto add = [&](bool condition, const char* name) {
        if (condition) defines.emplace_back(name);
    };
    add(packed_.parallelograms.size() > packed_.texturedParallelogramCount,
        "POLYLUME_PARALLELOGRAM_LIGHTS");
    add(packed_.triangleCount > 0, "POLYLUME_TRIANGLE_LIGHTS");
    add(packed_.polygons.size() > packed_.triangleCount + packed_.texturedPolygonCount,
        "POLYLUME_POLYGON_LIGHTS");
    add(packed_.texturedParallelogramCount > 0, "POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS");
    add(packed_.texturedPolygonCount > 0, "POLYLUME_TEXTURED_POLYGON_LIGHTS");
    add(!packed_.punctuals.empty(), "POLYLUME_PUNCTUAL_LIGHTS");
    add(packed_.diskCount > 0, "POLYLUME_DISK_LIGHTS");
    add(packed_.ellipses.size() > packed_.diskCount, "POLYLUME_ELLIPSE_LIGHTS");
    add(!packed_.spheres.empty(), "POLYLUME_SPHERE_LIGHTS");
    add(!packed_.tubes.empty(), "POLYLUME_TUBE_LIGHTS");
    add(specularTable_.lobeCount == 2, "POLYLUME_TWO_LOBES");
    add(model_.specular == Specular::beckmann, "POLYLUME_SPECULAR_BECKMANN");
    add(model_.diffuse == Diffuse::burley, "POLYLUME_DIFFUSE_BURLEY");
    add(model_.diffuse == Diffuse::orenNayar, "POLYLUME_DIFFUSE_OREN_NAYAR");
    add(model_.sheen, "POLYLUME_SHEEN");
    return defines;
}

void LightingPass::uploadSettings() {
    shared::LightingData data{};
    data.lightCount = {packed_.parallelograms.size() - packed_.texturedParallelogramCount,
                       packed_.polygons.size() - packed_.texturedPolygonCount,
                       packed_.punctuals.size(), packed_.triangleCount};
    data.texturedLightCount = {packed_.texturedParallelogramCount, packed_.texturedPolygonCount, 0,
                               0};
    data.roundLightCount = {packed_.ellipses.size(), packed_.spheres.size(), packed_.tubes.size(),
                            packed_.diskCount};
    data.textureScale = {1.0 / lightImages_.size(), lightImages_.levelCount() - 1, 0, 0};
    data.lobeWeight = {lobes_ != Lobes::specular, lobes_ != Lobes::diffuse, lobes_ == Lobes::all,
                       packed_.flatScale};
    data.lobeReferences = glm::vec4(specularTable_.reference, diffuseTable_.reference);
    data.sheenReference = glm::vec4(sheenTable_.reference, 0.0f, 0.0f);
    settings_ = gl::Buffer(gl_, gl::bytesOf(data), 0, "lighting settings");
}

}  // namespace polylume
