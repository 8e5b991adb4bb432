// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"

#include <algorithm>
#include <bit>
#include <initializer_list>

#include "lights/light_outline.hpp"

namespace polylume {
namespace {

using Contour = std::vector<glm::vec3>;

bool isParallelogram(const PolygonLight& light) {
    if (light.contours.size() != 1 || light.contours.front().size() != 4) return false;
    const Contour& c = light.contours.front();
    const glm::dvec3 gap =
        (glm::dvec3(c[1]) - glm::dvec3(c[0])) + (glm::dvec3(c[3]) - glm::dvec3(c[2]));
    const double perimeter = glm::distance(c[0], c[1]) + glm::distance(c[1], c[2]);
    // Corners rounded to float are off by their distance from the origin, too.
    const double reach =
        std::max({glm::length(c[0]), glm::length(c[1]), glm::length(c[2]), glm::length(c[3])});
    return glm::length(gap) <= 1e-6 * perimeter + 2e-7 * reach;
}

bool isTriangle(const PolygonLight& light) {
    return light.contours.size() == 1 && light.contours.front().size() == 3;
}

/// Rounding apart.
bool isDisk(const EllipseLight& light) {
    const glm::dvec3 x(light.halfAxisX);
    const glm::dvec3 y(light.halfAxisY);
    const double square = glm::dot(x, x);
    constexpr double kTolerance = 1e-6;
    return std::abs(square - glm::dot(y, y)) <= kTolerance * square &&
           std::abs(glm::dot(x, y)) <= kTolerance * square;
}

glm::dvec3 areaVector(const EllipseLight& light) {
    return glm::cross(glm::dvec3(light.halfAxisX), glm::dvec3(light.halfAxisY));
}

void packParallelogram(const PolygonLight& light, const glm::dvec3& normal,
                       shared::ParallelogramData& data) {
    const Contour& c = light.contours.front();
    data.corner = glm::vec4(c[0], light.twoSided ? 1.0f : 0.0f);
    data.edgeX = glm::vec4(c[1] - c[0], data.edgeX.w);
    data.edgeY = glm::vec4(c[3] - c[0], light.shownBySurface ? 1.0f : 0.0f);
    data.normal = glm::vec4(normal, data.normal.w);
    data.radiance = glm::vec4(light.radiance, data.radiance.w);
}

/// From the vertex that `data` has as its first.
void packPolygon(const PolygonLight& light, const glm::dvec3& normal, shared::PolygonData& data,
                 std::vector<glm::vec4>& vertices) {
    float extent = 0.0f;
    std::size_t at = data.vertices.x;
    for (const Contour& contour : light.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            vertices[at++] =
                glm::vec4(contour[i], i == 0 ? static_cast<float>(contour.size()) : 0.0f);
            extent = std::max(extent, glm::distance(contour[i], light.contours.front().front()));
        }
        vertices[at++] = glm::vec4(contour.front(), 0.0f);
    }
    data.vertices.z = std::bit_cast<std::uint32_t>(extent);
    data.vertices.w = light.shownBySurface ? 1 : 0;
    const double offset = -glm::dot(normal, glm::dvec3(light.contours.front().front()));
    data.plane = glm::vec4(normal, offset);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
}

/// As PackedLights::flatScale wants it of all lights.
float flatScaleOf(const PolygonLight& light) {
    constexpr float kMostLength = 1e9f;
    float largest = kMostLength;
    for (const Contour& contour : light.contours) {
        for (const glm::vec3& v : contour) largest = std::max(largest, glm::length(v));
    }
    return kMostLength / largest;
}

template <typename Light>
std::vector<LightPlace> kindsOf(const std::vector<Light>& lights) {
    std::vector<LightPlace> places;
    places.reserve(lights.size());
    for (const Light& light : lights) places.push_back({kindOf(light), 0});
    return places;
}

/// Gives the lights of each of `kinds`, one after the other, the next slots. Returns how many.
std::uint32_t assignSlots(std::initializer_list<LightKind> kinds, std::vector<LightPlace>& places) {
    std::uint32_t next = 0;
    for (const LightKind kind : kinds) {
        for (LightPlace& place : places) {
            if (place.kind == kind) place.slot = next++;
        }
    }
    return next;
}

std::uint32_t countOf(LightKind kind, const std::vector<LightPlace>& places) {
    return static_cast<std::uint32_t>(std::ranges::count(places, kind, &LightPlace::kind));
}

bool isInPolygons(LightKind kind) {
    return kind == LightKind::triangle || kind == LightKind::polygon ||
           kind == LightKind::texturedPolygon;
}

/// Vertices lie in the order of the polygons' slots.
void assignVertices(const std::vector<PolygonLight>& lights, PackedLights& packed) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const LightPlace& place = packed.places.polygons[i];
        if (!isInPolygons(place.kind)) continue;
        std::uint32_t& count = packed.polygons[place.slot].vertices.y;
        for (const Contour& contour : lights[i].contours) {
            count += static_cast<std::uint32_t>(contour.size()) + 1;
        }
    }
    std::uint32_t first = 0;
    for (shared::PolygonData& polygon : packed.polygons) {
        polygon.vertices.x = first;
        first += polygon.vertices.y;
    }
    packed.polygonVertices.resize(first);
}

void assignPlaces(const LightSet& lights, PackedLights& packed) {
    LightPlaces& places = packed.places;
    places = {kindsOf(lights.polygons), kindsOf(lights.ellipses), kindsOf(lights.spheres),
              kindsOf(lights.tubes), kindsOf(lights.punctuals)};
    packed.parallelograms.resize(
        assignSlots({LightKind::parallelogram, LightKind::texturedParallelogram}, places.polygons));
    packed.polygons.resize(assignSlots(
        {LightKind::triangle, LightKind::polygon, LightKind::texturedPolygon}, places.polygons));
    packed.ellipses.resize(assignSlots({LightKind::disk, LightKind::ellipse}, places.ellipses));
    packed.spheres.resize(assignSlots({LightKind::sphere}, places.spheres));
    packed.tubes.resize(assignSlots({LightKind::tube}, places.tubes));
    packed.punctuals.resize(assignSlots({LightKind::punctual}, places.punctuals));
    packed.triangleCount = countOf(LightKind::triangle, places.polygons);
    packed.texturedParallelogramCount = countOf(LightKind::texturedParallelogram, places.polygons);
    packed.texturedPolygonCount = countOf(LightKind::texturedPolygon, places.polygons);
    packed.diskCount = countOf(LightKind::disk, places.ellipses);
}

template <typename Light>
void packAll(const std::vector<Light>& lights, const std::vector<LightPlace>& places,
             PackedLights& packed) {
    for (std::size_t i = 0; i < lights.size(); ++i) packLight(lights[i], places[i], packed);
}

void addTextured(const std::vector<PolygonLight>& lights, LightKind kind, PackedLights& packed) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (packed.places.polygons[i].kind != kind) continue;
        const PolygonLight& light = lights[i];
        packed.texturedLights.push_back(
            {i, *light.texture, lightTextureFrame(light, kind == LightKind::texturedParallelogram),
             glm::vec2(1.0f)});
    }
}

}  // namespace

LightKind kindOf(const PolygonLight& light) {
    if (!(glm::length(areaVector(light.contours.front())) > 0.0)) return LightKind::none;
    if (isParallelogram(light)) {
        return light.texture ? LightKind::texturedParallelogram : LightKind::parallelogram;
    }
    if (light.texture) return LightKind::texturedPolygon;
    return isTriangle(light) ? LightKind::triangle : LightKind::polygon;
}

LightKind kindOf(const EllipseLight& light) {
    if (!(glm::length(areaVector(light)) > 0.0)) return LightKind::none;
    return isDisk(light) ? LightKind::disk : LightKind::ellipse;
}

LightKind kindOf(const SphereLight& light) {
    return light.radius > 0.0f ? LightKind::sphere : LightKind::none;
}

LightKind kindOf(const TubeLight& light) {
    return light.radius > 0.0f ? LightKind::tube : LightKind::none;
}

LightKind kindOf(const PunctualLight&) {
    return LightKind::punctual;
}

void packLight(const PolygonLight& light, const LightPlace& place, PackedLights& packed) {
    packed.flatScale = std::min(packed.flatScale, flatScaleOf(light));
    if (place.kind == LightKind::none) return;
    const glm::dvec3 area = areaVector(light.contours.front());
    const glm::dvec3 normal = area / glm::length(area);
    if (isInPolygons(place.kind)) {
        packPolygon(light, normal, packed.polygons[place.slot], packed.polygonVertices);
    } else {
        packParallelogram(light, normal, packed.parallelograms[place.slot]);
    }
}

void packLight(const EllipseLight& light, const LightPlace& place, PackedLights& packed) {
    if (place.kind == LightKind::none) return;
    shared::EllipseData& data = packed.ellipses[place.slot];
    data.center = glm::vec4(light.center, light.twoSided ? 1.0f : 0.0f);
    data.halfAxisX = glm::vec4(light.halfAxisX, 0.0f);
    data.halfAxisY = glm::vec4(light.halfAxisY, 0.0f);
    const glm::dvec3 area = areaVector(light);
    data.normal = glm::vec4(area / glm::length(area), 0.0f);
    data.radiance = glm::vec4(light.radiance, 0.0f);
}

void packLight(const SphereLight& light, const LightPlace& place, PackedLights& packed) {
    if (place.kind == LightKind::none) return;
    shared::SphereData& data = packed.spheres[place.slot];
    data.center = glm::vec4(light.center, light.radius);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
}

void packLight(const TubeLight& light, const LightPlace& place, PackedLights& packed) {
    if (place.kind == LightKind::none) return;
    shared::TubeData& data = packed.tubes[place.slot];
    data.start = glm::vec4(light.start, light.radius);
    data.axis = glm::vec4(light.end - light.start, 0.0f);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
}

void packLight(const PunctualLight& light, const LightPlace& place, PackedLights& packed) {
    shared::PunctualData& data = packed.punctuals[place.slot];
    data.position = glm::vec4(light.position, 1.0f / (light.range * light.range));
    data.direction =
        glm::vec4(light.direction, light.kind == PunctualLightKind::directional ? 1.0f : 0.0f);
    data.intensity = glm::vec4(light.intensity, 0.0f);
    // KHR_lights_punctual: (cos - cosOuter) / (cosInner - cosOuter), clamped and squared.
    data.cone = glm::vec4(0.0f, 1.0f, 0.0f, 0.0f);
    if (light.kind == PunctualLightKind::spot) {
        const float cosOuter = std::cos(light.outerConeAngle);
        const float width = std::max(std::cos(light.innerConeAngle) - cosOuter, 1e-3f);
        data.cone = glm::vec4(1.0f / width, -cosOuter / width, 0.0f, 0.0f);
    }
}

PackedLights packLights(const LightSet& lights) {
    checkLights(lights);
    PackedLights packed;
    assignPlaces(lights, packed);
    assignVertices(lights.polygons, packed);
    packAll(lights.polygons, packed.places.polygons, packed);
    packAll(lights.ellipses, packed.places.ellipses, packed);
    packAll(lights.spheres, packed.places.spheres, packed);
    packAll(lights.tubes, packed.places.tubes, packed);
    packAll(lights.punctuals, packed.places.punctuals, packed);
    addTextured(lights.polygons, LightKind::texturedParallelogram, packed);
    addTextured(lights.polygons, LightKind::texturedPolygon, packed);
    return packed;
}

}  // namespace polylume
