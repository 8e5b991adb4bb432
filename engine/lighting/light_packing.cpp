// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"
#include "lights/light_outline.hpp"

#include <algorithm>
#include <bit>

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

shared::ParallelogramData packParallelogram(const PolygonLight& light, const glm::dvec3& normal) {
    const Contour& c = light.contours.front();
    shared::ParallelogramData data{};
    data.corner = glm::vec4(c[0], light.twoSided ? 1.0f : 0.0f);
    data.edgeX = glm::vec4(c[1] - c[0], 0.0f);
    data.edgeY = glm::vec4(c[3] - c[0], light.shownBySurface ? 1.0f : 0.0f);
    data.normal = glm::vec4(normal, 0.0f);
    data.radiance = glm::vec4(light.radiance, 0.0f);
    return data;
}

shared::PolygonData packPolygon(const PolygonLight& light, const glm::dvec3& normal,
                                std::vector<glm::vec4>& vertices) {
    shared::PolygonData data{};
    float extent = 0.0f;
    data.vertices.x = static_cast<std::uint32_t>(vertices.size());
    for (const Contour& contour : light.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            vertices.emplace_back(contour[i], i == 0 ? static_cast<float>(contour.size()) : 0.0f);
            extent = std::max(extent, glm::distance(contour[i], light.contours.front().front()));
        }
        vertices.emplace_back(contour.front(), 0.0f);
    }
    data.vertices.y = static_cast<std::uint32_t>(vertices.size()) - data.vertices.x;
    data.vertices.z = std::bit_cast<std::uint32_t>(extent);
    data.vertices.w = light.shownBySurface ? 1 : 0;
    const double offset = -glm::dot(normal, glm::dvec3(light.contours.front().front()));
    data.plane = glm::vec4(normal, offset);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
    return data;
}

shared::PunctualData packPunctual(const PunctualLight& light) {
    shared::PunctualData data{};
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
    return data;
}

bool isTriangle(const PolygonLight& light) {
    return light.contours.size() == 1 && light.contours.front().size() == 3;
}

bool hasArea(const PolygonLight& light) {
    return glm::length(areaVector(light.contours.front())) > 0.0;
}

void pack(const PolygonLight& light, PackedLights& packed) {
    const glm::dvec3 area = areaVector(light.contours.front());
    const double length = glm::length(area);
    if (!(length > 0.0)) return;
    const glm::dvec3 normal = area / length;
    if (isParallelogram(light)) {
        packed.parallelograms.push_back(packParallelogram(light, normal));
    } else {
        packed.polygons.push_back(packPolygon(light, normal, packed.polygonVertices));
    }
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

void pack(const EllipseLight& light, PackedLights& packed) {
    const glm::dvec3 area = glm::cross(glm::dvec3(light.halfAxisX), glm::dvec3(light.halfAxisY));
    const double length = glm::length(area);
    if (!(length > 0.0)) return;
    shared::EllipseData data{};
    data.center = glm::vec4(light.center, light.twoSided ? 1.0f : 0.0f);
    data.halfAxisX = glm::vec4(light.halfAxisX, 0.0f);
    data.halfAxisY = glm::vec4(light.halfAxisY, 0.0f);
    data.normal = glm::vec4(area / length, 0.0f);
    data.radiance = glm::vec4(light.radiance, 0.0f);
    packed.ellipses.push_back(data);
}

void pack(const SphereLight& light, PackedLights& packed) {
    if (!(light.radius > 0.0f)) return;
    shared::SphereData data{};
    data.center = glm::vec4(light.center, light.radius);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
    packed.spheres.push_back(data);
}

void pack(const TubeLight& light, PackedLights& packed) {
    if (!(light.radius > 0.0f)) return;
    shared::TubeData data{};
    data.start = glm::vec4(light.start, light.radius);
    data.axis = glm::vec4(light.end - light.start, 0.0f);
    data.radiance = glm::vec4(light.radiance, light.twoSided ? 1.0f : 0.0f);
    packed.tubes.push_back(data);
}

/// Appends the lights with a texture, parallelograms or others.
void packTextured(const std::vector<PolygonLight>& lights, bool parallelograms,
                  PackedLights& packed) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const PolygonLight& light = lights[i];
        if (!light.texture || isParallelogram(light) != parallelograms || !hasArea(light)) continue;
        pack(light, packed);
        packed.texturedLights.push_back(
            {i, *light.texture, lightTextureFrame(light, parallelograms), glm::vec2(1.0f)});
        ++(parallelograms ? packed.texturedParallelogramCount : packed.texturedPolygonCount);
    }
}

/// As PackedLights::flatScale.
float flatScaleOf(const LightSet& lights) {
    constexpr float kMostLength = 1e9f;
    float largest = kMostLength;
    for (const PolygonLight& light : lights.polygons) {
        for (const Contour& contour : light.contours) {
            for (const glm::vec3& v : contour) largest = std::max(largest, glm::length(v));
        }
    }
    return kMostLength / largest;
}

}  // namespace

PackedLights packLights(const LightSet& lights) {
    checkLights(lights);
    PackedLights packed;
    for (const PolygonLight& light : lights.polygons) {
        if (isTriangle(light) && !light.texture) pack(light, packed);
    }
    packed.flatScale = flatScaleOf(lights);
    packed.triangleCount = static_cast<std::uint32_t>(packed.polygons.size());
    for (const PolygonLight& light : lights.polygons) {
        if (!isTriangle(light) && !light.texture) pack(light, packed);
    }
    packTextured(lights.polygons, true, packed);
    packTextured(lights.polygons, false, packed);
    for (const EllipseLight& light : lights.ellipses) {
        if (isDisk(light)) pack(light, packed);
    }
    packed.diskCount = static_cast<std::uint32_t>(packed.ellipses.size());
    for (const EllipseLight& light : lights.ellipses) {
        if (!isDisk(light)) pack(light, packed);
    }
    for (const SphereLight& light : lights.spheres) pack(light, packed);
    for (const TubeLight& light : lights.tubes) pack(light, packed);
    for (const PunctualLight& light : lights.punctuals) {
        packed.punctuals.push_back(packPunctual(light));
    }
    return packed;
}

}  // namespace polylume
