// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"

#include <algorithm>

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
    data.edgeY = glm::vec4(c[3] - c[0], 0.0f);
    data.normal = glm::vec4(normal, 0.0f);
    data.radiance = glm::vec4(light.radiance, 0.0f);
    return data;
}

shared::PolygonData packPolygon(const PolygonLight& light, const glm::dvec3& normal,
                                std::vector<glm::vec4>& vertices) {
    shared::PolygonData data{};
    data.vertices.x = static_cast<std::uint32_t>(vertices.size());
    for (const Contour& contour : light.contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            vertices.emplace_back(contour[i], i == 0 ? 1.0f : 0.0f);
        }
        vertices.emplace_back(contour.front(), 0.0f);
    }
    data.vertices.y = static_cast<std::uint32_t>(vertices.size()) - data.vertices.x;
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

}  // namespace

PackedLights packLights(const LightSet& lights) {
    checkLights(lights);
    PackedLights packed;
    for (const PolygonLight& light : lights.polygons) pack(light, packed);
    for (const EllipseLight& light : lights.ellipses) {
        pack(PolygonLight{{outline(light)}, light.radiance, light.twoSided}, packed);
    }
    for (const PunctualLight& light : lights.punctuals) {
        packed.punctuals.push_back(packPunctual(light));
    }
    return packed;
}

}  // namespace polylume
