// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "lighting/lighting_resources.hpp"
#include "lights/light_check.hpp"
#include "polylume/error.hpp"

// LightingResources::update(): lights by range.
namespace polylume {
namespace {

/// What the functions below need to know of a type of light.
template <typename Light>
struct ListOf;
template <>
struct ListOf<PolygonLight> {
    static constexpr const char* kName = "polygon";
    static constexpr auto kLights = &LightSet::polygons;
    static constexpr auto kPlaces = &LightPlaces::polygons;
};
template <>
struct ListOf<EllipseLight> {
    static constexpr const char* kName = "ellipse";
    static constexpr auto kLights = &LightSet::ellipses;
    static constexpr auto kPlaces = &LightPlaces::ellipses;
};
template <>
struct ListOf<SphereLight> {
    static constexpr const char* kName = "sphere";
    static constexpr auto kLights = &LightSet::spheres;
    static constexpr auto kPlaces = &LightPlaces::spheres;
};
template <>
struct ListOf<TubeLight> {
    static constexpr const char* kName = "tube";
    static constexpr auto kLights = &LightSet::tubes;
    static constexpr auto kPlaces = &LightPlaces::tubes;
};
template <>
struct ListOf<PunctualLight> {
    static constexpr const char* kName = "punctual";
    static constexpr auto kLights = &LightSet::punctuals;
    static constexpr auto kPlaces = &LightPlaces::punctuals;
};

template <typename Light>
void checkRange(std::size_t first, std::size_t count, std::size_t lightCount) {
    if (first <= lightCount && count <= lightCount - first) return;
    throw Error(concat("expected a range of the ", lightCount, " ", ListOf<Light>::kName,
                       " lights of the last setLights(), found ", count, " from index ", first));
}

bool isTextured(LightKind kind) {
    return kind == LightKind::texturedParallelogram || kind == LightKind::texturedPolygon;
}

/// Takes `to` over into `from` in the memory that is there; the image of a texture stays.
void assign(PolygonLight& from, const PolygonLight& to) {
    std::shared_ptr<const LightImage> image;
    if (from.texture && to.texture) image = from.texture->image;
    from = to;
    if (image) from.texture->image = std::move(image);
}

template <typename Light>
void assign(Light& from, const Light& to) {
    from = to;
}

}  // namespace

bool LightingResources::canReplace(std::size_t index, const PolygonLight& light) {
    const PolygonLight& before = inUse_.lights.polygons[index];
    // A texture that was there keeps its image.
    checkLight(light, index, checkStorage_, !before.texture);
    const LightPlace& place = inUse_.packed.places.polygons[index];
    if (kindOf(light) != place.kind || light.texture.has_value() != before.texture.has_value()) {
        return false;
    }
    if (!std::ranges::equal(light.contours, before.contours, {}, &std::vector<glm::vec3>::size,
                            &std::vector<glm::vec3>::size)) {
        return false;
    }
    if (!isTextured(place.kind)) return true;
    const TexturedLight& textured = inUse_.images.lights()[layerOf(place)];
    return movedFrame(light, place.kind == LightKind::texturedParallelogram, textured.frame,
                      textured.texture)
        .has_value();
}

template <typename Light>
bool LightingResources::canReplace(std::size_t index, const Light& light) {
    checkLight(light, index);
    return kindOf(light) == (inUse_.packed.places.*ListOf<Light>::kPlaces)[index].kind;
}

void LightingResources::moveImage(const PolygonLight& light, const LightPlace& place) {
    const std::size_t layer = layerOf(place);
    const TexturedLight& textured = inUse_.images.lights()[layer];
    const bool isParallelogram = place.kind == LightKind::texturedParallelogram;
    const LightFrameEdges edges =
        *movedFrame(light, isParallelogram, textured.frame, textured.texture);
    inUse_.images.move(layer, edges);
    if (isParallelogram) return;
    shared::LightTextureData& data =
        inUse_.textures[layer - inUse_.packed.texturedParallelogramCount];
    data.corner = glm::vec4(edges.corner, data.corner.w);
    data.edgeX = glm::vec4(edges.edgeX, data.edgeX.w);
    data.edgeY = glm::vec4(edges.edgeY, data.edgeY.w);
}

template <typename Light>
void LightingResources::replace(std::size_t index, const Light& light) {
    const LightPlace& place = (inUse_.packed.places.*ListOf<Light>::kPlaces)[index];
    packLight(light, place, inUse_.packed);
    if constexpr (std::is_same_v<Light, PolygonLight>) {
        if (isTextured(place.kind)) moveImage(light, place);
    }
    assign((inUse_.lights.*ListOf<Light>::kLights)[index], light);
}

template <typename Light>
bool LightingResources::update(std::size_t first, std::span<const Light> lights) {
    checkRange<Light>(first, lights.size(), (inUse_.lights.*ListOf<Light>::kLights).size());
    bool canReplaceAll = true;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        // All are checked, also past one that changes its kind.
        if (!canReplace(first + i, lights[i])) canReplaceAll = false;
    }
    if (!canReplaceAll) return false;

    // Neighbours in a list that are of one kind are neighbours there, too.
    constexpr std::size_t kKindCount = static_cast<std::size_t>(LightKind::punctual) + 1;
    std::array<SlotRange, kKindCount> slots;
    const float flatScale = inUse_.packed.flatScale;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        replace(first + i, lights[i]);
        const LightPlace& place = (inUse_.packed.places.*ListOf<Light>::kPlaces)[first + i];
        slots[static_cast<std::size_t>(place.kind)].include(place.slot);
    }
    for (std::size_t kind = 0; kind < kKindCount; ++kind) {
        inUse_.buffers.update(inUse_.packed, static_cast<LightKind>(kind), slots[kind]);
    }
    SlotRange textures = slots[static_cast<std::size_t>(LightKind::texturedPolygon)];
    if (textures.end > 0) {
        const std::size_t plain = inUse_.packed.polygons.size() - inUse_.textures.size();
        textures.first -= static_cast<std::uint32_t>(plain);
        textures.end -= static_cast<std::uint32_t>(plain);
        inUse_.buffers.update(inUse_.textures, textures);
    }
    ++revision_;
    if (inUse_.packed.flatScale != flatScale) uploadSettings();
    return true;
}

template <typename Light>
LightSet LightingResources::replaced(std::size_t first, std::span<const Light> lights) const {
    checkRange<Light>(first, lights.size(), (inUse_.lights.*ListOf<Light>::kLights).size());
    LightSet set = inUse_.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        assign((set.*ListOf<Light>::kLights)[first + i], lights[i]);
    }
    return set;
}

#define POLYLUME_UPDATE(Light)                                                           \
    template bool LightingResources::update<Light>(std::size_t, std::span<const Light>); \
    template LightSet LightingResources::replaced<Light>(std::size_t, std::span<const Light>) const

POLYLUME_UPDATE(PolygonLight);
POLYLUME_UPDATE(EllipseLight);
POLYLUME_UPDATE(SphereLight);
POLYLUME_UPDATE(TubeLight);
POLYLUME_UPDATE(PunctualLight);

}  // namespace polylume
