// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/c_lights.hpp"

#include <algorithm>

#include "embed/c_values.hpp"

namespace polylume::embed {
namespace {

constexpr TextureWrap kWraps[] = {TextureWrap::clampToEdge, TextureWrap::repeat,
                                  TextureWrap::mirroredRepeat};
constexpr PunctualLightKind kPunctualKinds[] = {PunctualLightKind::directional,
                                                PunctualLightKind::point, PunctualLightKind::spot};

glm::vec3 vec3From(const float (&values)[3]) {
    return {values[0], values[1], values[2]};
}

std::shared_ptr<const LightImage> copyImage(const polylume_light_texture& texture) {
    if (texture.width < 1 || texture.height < 1) {
        throw Error(
            concat("expected \"width\" and \"height\" of the texture of a polygon light to "
                   "be 1 or more, found ",
                   texture.width, "x", texture.height));
    }
    const float* texels = required(texture.texels, "texels");
    auto image = std::make_shared<LightImage>();
    image->size = {texture.width, texture.height};
    image->texels.resize(static_cast<std::size_t>(texture.width) *
                         static_cast<std::size_t>(texture.height));
    for (glm::vec3& texel : image->texels) {
        texel = {texels[0], texels[1], texels[2]};
        texels += 3;
    }
    return image;
}

/// `image`: the one that the light has; null: a copy of the texture's.
void copyTexture(const polylume_light_texture& source, std::shared_ptr<const LightImage> image,
                 LightTexture& texture) {
    texture.image = image != nullptr ? std::move(image) : copyImage(source);
    texture.origin = vec3From(source.origin);
    texture.axisU = vec3From(source.axis_u);
    texture.axisV = vec3From(source.axis_v);
    texture.wrapU = enumValue(kWraps, source.wrap_u, "wrap_u");
    texture.wrapV = enumValue(kWraps, source.wrap_v, "wrap_v");
}

void copyContours(const polylume_polygon_light& source, PolygonLight& light) {
    light.contours.resize(source.contour_count);
    if (source.contour_count == 0) return;
    const std::uint32_t* sizes = required(source.contour_sizes, "contour_sizes");
    const float* vertex = required(source.vertices, "vertices");
    for (std::vector<glm::vec3>& contour : light.contours) {
        contour.resize(*sizes++);
        for (glm::vec3& position : contour) {
            position = {vertex[0], vertex[1], vertex[2]};
            vertex += 3;
        }
    }
}

void copyLight(const polylume_polygon_light& source, std::shared_ptr<const LightImage> image,
               PolygonLight& light) {
    copyContours(source, light);
    light.radiance = vec3From(source.radiance);
    light.twoSided = source.two_sided != 0;
    if (source.texture == nullptr) {
        light.texture.reset();
        return;
    }
    if (!light.texture) light.texture.emplace();
    copyTexture(*source.texture, std::move(image), *light.texture);
}

void copyLight(const polylume_ellipse_light& source, EllipseLight& light) {
    light.center = vec3From(source.center);
    light.halfAxisX = vec3From(source.half_axis_x);
    light.halfAxisY = vec3From(source.half_axis_y);
    light.radiance = vec3From(source.radiance);
    light.twoSided = source.two_sided != 0;
}

void copyLight(const polylume_sphere_light& source, SphereLight& light) {
    light.center = vec3From(source.center);
    light.radius = source.radius;
    light.radiance = vec3From(source.radiance);
    light.twoSided = source.two_sided != 0;
}

void copyLight(const polylume_tube_light& source, TubeLight& light) {
    light.start = vec3From(source.start);
    light.end = vec3From(source.end);
    light.radius = source.radius;
    light.radiance = vec3From(source.radiance);
    light.twoSided = source.two_sided != 0;
}

void copyLight(const polylume_punctual_light& source, PunctualLight& light) {
    light.kind = enumValue(kPunctualKinds, source.kind, "kind");
    light.position = vec3From(source.position);
    light.direction = vec3From(source.direction);
    light.intensity = vec3From(source.intensity);
    light.range = source.range == 0.0f ? INFINITY : source.range;
    light.innerConeAngle = source.inner_cone_angle;
    light.outerConeAngle = source.outer_cone_angle;
}

/// The lights of a list of a set, `name` it and `countName` how many it says it has.
template <typename Source>
std::span<const Source> listOf(const Source* lights, std::size_t count, const char* name,
                               const char* countName) {
    if (lights == nullptr && count > 0) {
        throw Error(
            concat("expected \"", name, "\" not to be NULL, as \"", countName, "\" is ", count));
    }
    return {lights, count};
}

/// The places of an update.
template <typename Light>
std::span<Light> places(std::vector<Light>& lights, std::size_t first, const void* source,
                        std::size_t count, const char* kind) {
    if (first > lights.size() || count > lights.size() - first) {
        throw Error(concat("expected lights to update among the ", lights.size(), " ", kind,
                           " lights of the last polylume_lighting_set_lights(), found ", count,
                           " from index ", first));
    }
    if (count > 0) required(source, "lights");
    return std::span(lights).subspan(first, count);
}

template <typename Light, typename Source>
std::span<const Light> update(std::vector<Light>& lights, std::size_t first, const Source* source,
                              std::size_t count, const char* kind) {
    const std::span<Light> updated = places(lights, first, source, count, kind);
    for (Light& light : updated) copyLight(*source++, light);
    return updated;
}

template <typename Light, typename Source>
void copyList(std::span<const Source> sources, std::vector<Light>& lights) {
    lights.resize(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) copyLight(sources[i], lights[i]);
}

}  // namespace

CLights CLights::copyOf(const polylume_light_set& lights) {
    CLights copy;
    LightSet& set = copy.set_;
    const auto polygons =
        listOf(lights.polygons, lights.polygon_count, "polygons", "polygon_count");
    set.polygons.resize(polygons.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        copyLight(polygons[i], nullptr, set.polygons[i]);
    }
    copyList(listOf(lights.ellipses, lights.ellipse_count, "ellipses", "ellipse_count"),
             set.ellipses);
    copyList(listOf(lights.spheres, lights.sphere_count, "spheres", "sphere_count"), set.spheres);
    copyList(listOf(lights.tubes, lights.tube_count, "tubes", "tube_count"), set.tubes);
    copyList(listOf(lights.punctuals, lights.punctual_count, "punctuals", "punctual_count"),
             set.punctuals);
    copy.images_.resize(polygons.size());
    copy.keepImages(0, polygons.size());
    return copy;
}

std::span<const PolygonLight> CLights::updatePolygons(std::size_t first,
                                                      const polylume_polygon_light* lights,
                                                      std::size_t count) {
    const std::span<PolygonLight> updated = places(set_.polygons, first, lights, count, "polygon");
    for (std::size_t i = 0; i < count; ++i) copyLight(lights[i], images_[first + i], updated[i]);
    return updated;
}

void CLights::keepImages(std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
        const std::optional<LightTexture>& texture = set_.polygons[i].texture;
        images_[i] = texture ? texture->image : nullptr;
    }
}

std::span<const EllipseLight> CLights::updateEllipses(std::size_t first,
                                                      const polylume_ellipse_light* lights,
                                                      std::size_t count) {
    return update(set_.ellipses, first, lights, count, "ellipse");
}

std::span<const SphereLight> CLights::updateSpheres(std::size_t first,
                                                    const polylume_sphere_light* lights,
                                                    std::size_t count) {
    return update(set_.spheres, first, lights, count, "sphere");
}

std::span<const TubeLight> CLights::updateTubes(std::size_t first,
                                                const polylume_tube_light* lights,
                                                std::size_t count) {
    return update(set_.tubes, first, lights, count, "tube");
}

std::span<const PunctualLight> CLights::updatePunctuals(std::size_t first,
                                                        const polylume_punctual_light* lights,
                                                        std::size_t count) {
    return update(set_.punctuals, first, lights, count, "punctual");
}

}  // namespace polylume::embed
