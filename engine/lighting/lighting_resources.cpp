// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_resources.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "lighting/light_summary.hpp"
#include "lights/texture_check.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

/// Tells the packed lights where their images are. Returns what textured polygons have of their
/// own.
std::vector<shared::LightTextureData> placeImages(const std::vector<TexturedLight>& lights,
                                                  PackedLights& packed) {
    const std::size_t first = packed.parallelograms.size() - packed.texturedParallelogramCount;
    std::vector<shared::LightTextureData> textures;
    for (std::size_t layer = 0; layer < lights.size(); ++layer) {
        const LightTextureFrame& frame = lights[layer].frame;
        const auto layerNumber = static_cast<float>(layer);
        const glm::vec2 texels(frame.size);
        if (layer < packed.texturedParallelogramCount) {
            shared::ParallelogramData& data = packed.parallelograms[first + layer];
            data.normal.w = layerNumber;
            data.edgeX.w = texels.x;
            data.radiance.w = texels.y;
            continue;
        }
        textures.push_back({glm::vec4(frame.corner, layerNumber), glm::vec4(frame.edgeX, texels.x),
                            glm::vec4(frame.edgeY, texels.y),
                            glm::vec4(frame.center, 1.0 / frame.variance)});
    }
    return textures;
}

float brightestTexelOf(const LightImage& image) {
    float brightest = 0.0f;
    for (const glm::vec3& texel : image.texels) {
        brightest = std::max({brightest, texel.r, texel.g, texel.b});
    }
    return brightest;
}

std::vector<float> brightestTexelsOf(const LightSet& lights) {
    std::vector<float> brightest(lights.polygons.size(), 1.0f);
    std::map<const LightImage*, float> known;  // Many lights may have the same.
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        const std::optional<LightTexture>& texture = lights.polygons[i].texture;
        if (!texture || !texture->image) continue;
        const auto [entry, isNew] = known.try_emplace(texture->image.get());
        if (isNew) entry->second = brightestTexelOf(*texture->image);
        brightest[i] = entry->second;
    }
    return brightest;
}

}  // namespace

LightingResources::LightingResources(const gl::Functions& gl, const gl::ShaderLibrary& library,
                                     const LightingModel& model, const ltc::Table* specularTable)
    : gl_(gl),
      library_(library),
      model_(model),
      tables_(gl, model, specularTable),
      settings_(gl, gl::bytesOf(shared::LightingData{}), GL_DYNAMIC_STORAGE_BIT,
                "lighting settings") {
    use(prepare({}));
}

PreparedLights LightingResources::prepare(LightSet lights) {
    PreparedLights prepared;
    prepared.packed = packLights(lights);
    PackedLights& packed = prepared.packed;
    if (!packed.texturedLights.empty() && !imagePrograms_) {
        imagePrograms_ = std::make_shared<LightImagePrograms>(gl_, library_);
    }
    prepared.images = LightTextureArray(gl_, imagePrograms_, std::move(packed.texturedLights));
    prepared.textures = placeImages(prepared.images.lights(), packed);
    prepared.buffers = LightBuffers(gl_, packed, prepared.textures);
    prepared.defines = makeDefines(packed);
    prepared.brightestTexels = brightestTexelsOf(lights);
    prepared.lights = std::move(lights);
    return prepared;
}

void LightingResources::use(PreparedLights prepared) {
    inUse_ = std::move(prepared);
    ++revision_;
    uploadSettings();
}

void LightingResources::setLobes(Lobes lobes) {
    lobes_ = lobes;
    uploadSettings();
}

void LightingResources::bind() const {
    const GLuint settings = settings_.name();
    gl_.BindBuffersBase(GL_UNIFORM_BUFFER, shared::kLightingBinding, 1, &settings);
    inUse_.buffers.bind(gl_);
    tables_.bind(gl_);
    if (!inUse_.images.lights().empty()) inUse_.images.bind(shared::kLightImageUnit);
}

std::size_t LightingResources::layerOf(const LightPlace& place) const {
    const PackedLights& packed = inUse_.packed;
    if (place.kind == LightKind::texturedParallelogram) {
        return place.slot - (packed.parallelograms.size() - packed.texturedParallelogramCount);
    }
    return packed.texturedParallelogramCount + place.slot -
           (packed.polygons.size() - packed.texturedPolygonCount);
}

std::size_t LightingResources::imageLayer(std::size_t polygon) const {
    const std::vector<LightPlace>& places = inUse_.packed.places.polygons;
    if (polygon >= places.size()) {
        throw Error(concat("expected the index of a polygon light of the last setLights(), below ",
                           places.size(), ", found ", polygon));
    }
    const LightPlace& place = places[polygon];
    if (place.kind == LightKind::texturedParallelogram ||
        place.kind == LightKind::texturedPolygon) {
        return layerOf(place);
    }
    throw Error(concat("expected polygon light ", polygon,
                       " to have a texture and an area, found none; give it a texture in "
                       "setLights() first"));
}

void LightingResources::updateLightTexture(std::size_t polygon, GLuint texture) {
    inUse_.images.update(imageLayer(polygon), texture);
    // Its texels are on the GPU, and nobody waits for them. A film is not another light each frame.
    float& brightest = inUse_.brightestTexels[polygon];
    if (brightest == static_cast<float>(LightSummary::kUnbounded)) return;
    brightest = static_cast<float>(LightSummary::kUnbounded);
    ++revision_;
}

void LightingResources::updateLightTexture(std::size_t polygon, const LightImage& image) {
    const std::size_t layer = imageLayer(polygon);
    checkLightImage(image, polygon);
    inUse_.images.update(layer, image);
    inUse_.brightestTexels[polygon] = brightestTexelOf(image);
    ++revision_;
}

void LightingResources::updateGroups(const std::vector<shared::ParallelogramData>& groups) {
    inUse_.buffers.updateGroups(inUse_.packed, groups);
}

void LightingResources::setTilesAcross(std::uint32_t tileCount) {
    if (tileCount == tilesAcross_) return;
    tilesAcross_ = tileCount;
    uploadSettings();
}

std::vector<std::string> LightingResources::makeDefines(const PackedLights& packed) const {
    std::vector<std::string> defines;
    const auto add = [&](bool condition, const char* name) {
        if (condition) defines.emplace_back(name);
    };
    add(packed.parallelograms.size() > packed.texturedParallelogramCount,
        "POLYLUME_PARALLELOGRAM_LIGHTS");
    add(packed.triangleCount > 0, "POLYLUME_TRIANGLE_LIGHTS");
    add(packed.polygons.size() > packed.triangleCount + packed.texturedPolygonCount,
        "POLYLUME_POLYGON_LIGHTS");
    add(packed.texturedParallelogramCount > 0, "POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS");
    add(packed.texturedPolygonCount > 0, "POLYLUME_TEXTURED_POLYGON_LIGHTS");
    add(!packed.punctuals.empty(), "POLYLUME_PUNCTUAL_LIGHTS");
    add(packed.diskCount > 0, "POLYLUME_DISK_LIGHTS");
    add(packed.ellipses.size() > packed.diskCount, "POLYLUME_ELLIPSE_LIGHTS");
    add(!packed.spheres.empty(), "POLYLUME_SPHERE_LIGHTS");
    add(!packed.tubes.empty(), "POLYLUME_TUBE_LIGHTS");
    for (std::string& define : modelDefines()) defines.push_back(std::move(define));
    return defines;
}

std::vector<std::string> LightingResources::modelDefines() const {
    std::vector<std::string> defines;
    const auto add = [&](bool condition, const char* name) {
        if (condition) defines.emplace_back(name);
    };
    add(tables_.specularLobeCount() == 2, "POLYLUME_TWO_LOBES");
    add(model_.specular == Specular::beckmann, "POLYLUME_SPECULAR_BECKMANN");
    add(model_.diffuse == Diffuse::burley, "POLYLUME_DIFFUSE_BURLEY");
    add(model_.diffuse == Diffuse::orenNayar, "POLYLUME_DIFFUSE_OREN_NAYAR");
    add(model_.sheen, "POLYLUME_SHEEN");
    return defines;
}

void LightingResources::uploadSettings() {
    const PackedLights& packed = inUse_.packed;
    const LightTextureArray& images = inUse_.images;
    shared::LightingData data{};
    data.lightCount = {packed.parallelograms.size() - packed.texturedParallelogramCount,
                       packed.polygons.size() - packed.texturedPolygonCount,
                       packed.punctuals.size(), packed.triangleCount};
    data.texturedLightCount = {packed.texturedParallelogramCount, packed.texturedPolygonCount,
                               tilesAcross_, 0};
    data.roundLightCount = {packed.ellipses.size(), packed.spheres.size(), packed.tubes.size(),
                            packed.diskCount};
    const LightBuffers& buffers = inUse_.buffers;
    data.firstTexel = {buffers.firstTexel(shared::kParallelogramBinding),
                       buffers.firstTexel(shared::kPolygonBinding),
                       buffers.firstTexel(shared::kPolygonVertexBinding),
                       buffers.firstTexel(shared::kLightTextureBinding)};
    data.firstRoundTexel = {buffers.firstTexel(shared::kEllipseBinding),
                            buffers.firstTexel(shared::kSphereBinding),
                            buffers.firstTexel(shared::kTubeBinding), 0};
    data.textureScale = {1.0 / images.size(), images.levelCount() - 1, 0, 0};
    data.lobeWeight = {lobes_ != Lobes::specular, lobes_ != Lobes::diffuse, lobes_ == Lobes::all,
                       packed.flatScale};
    data.lobeReferences = tables_.lobeReferences();
    data.sheenReference = glm::vec4(tables_.sheenReference(), 0.0f, 0.0f);
    settings_.update(gl::bytesOf(data));
}

}  // namespace polylume
