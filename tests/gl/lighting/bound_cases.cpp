// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bound_cases.hpp"

#include <bit>

#include "core/text.hpp"
#include "lighting/light_tree.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::test {
namespace {

constexpr int kTile = static_cast<int>(shared::kTileSize);

glm::vec3 tangentOf(const glm::vec3& normal) {
    return glm::normalize(
        glm::cross(normal, std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0)));
}

}  // namespace

glm::vec3 BoundCases::unitVector() {
    const float z = uniform(-1, 1);
    const float angle = uniform(0, 6.2831853f);
    const float radius = std::sqrt(1.0f - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<ShadingPoint> BoundCases::makePoints(int size, bool withSheen) {
    std::vector<ShadingPoint> points(static_cast<std::size_t>(size) * size);
    for (int tileY = 0; tileY < size / kTile; ++tileY) {
        for (int tileX = 0; tileX < size / kTile; ++tileX) {
            const int kind = pick(0, 5);
            const float viewDegrees = pick(0, 2) == 0 ? uniform(80, 89.5f) : uniform(0, 80);
            const float view = glm::radians(viewDegrees);
            const float around = uniform(0, 6.2831853f);
            const glm::vec3 normal(std::sin(view) * std::cos(around),
                                   std::sin(view) * std::sin(around), std::cos(view));
            ShadingPoint base;
            base.distance = uniform(2, 8);
            base.roughness = std::array{0.0f, uniform(0, 0.1f), uniform(0, 1), uniform(0.3f, 1),
                                        1.0f}[pick(0, 4)];
            base.diffuseAlbedo = color();
            base.f0 = pick(0, 1) == 0 ? color() : glm::vec3(0.04f);
            if (pick(0, 2) == 0) base.diffuseAlbedo = glm::vec3(0.0f);
            if (pick(0, 5) == 0) base.f0 = glm::vec3(0.0f);
            base.f90 = pick(0, 1) == 0 ? 1.0f : uniform(0, 1);
            if (base.f0 == glm::vec3(0.0f) && pick(0, 1) == 0) base.f90 = 0.0f;
            if (withSheen && pick(0, 2) > 0) base.sheenColor = color();
            base.sheenRoughness = uniform(0, 1);
            const float bump = std::array{0.0f, 0.0f, 0.02f, 0.3f, 0.3f, 2.0f}[kind];
            const float spread = std::array{0.0f, 0.0f, 0.02f, 0.02f, 1.0f, 1.0f}[kind];
            const glm::vec3 bend = 0.02f * unitVector();
            const glm::vec3 other = glm::normalize(unitVector() + glm::vec3(0, 0, 1.2f));
            for (int i = 0; i < kTile * kTile; ++i) {
                const int x = i % kTile, y = i / kTile;
                ShadingPoint point = base;
                glm::vec3 n = normal + bump * uniform(0, 1) * unitVector();
                if (kind == 1) n += static_cast<float>(x) * bend;
                // Another surface in the other half.
                if (kind >= 3 && x > y) {
                    n = other;
                    point.roughness = 1.0f - base.roughness;
                }
                if (n.z < 0.008f) n.z = 0.008f;
                point.normalWorld = glm::normalize(n);
                if (normal.z > 0.15f) {
                    const glm::vec2 offset = glm::vec2(x - 8, y - 8) / 64.0f;
                    point.distance += (normal.x * offset.x + normal.y * offset.y) / normal.z;
                }
                point.distance += spread * uniform(-1, 1);
                if (kind == 4 && pick(0, 1) == 0) point.distance = 16.0f;  // Background.
                points[static_cast<std::size_t>((tileY * kTile + y) * size + tileX * kTile + x)] =
                    point;
            }
        }
    }
    return points;
}

glm::vec3 BoundCases::directionFrom(const SurfacePixel& pixel, const LightingModel& model) {
    const glm::vec3 n = glm::normalize(pixel.normalWorld);
    const glm::vec3 v = glm::normalize(pixel.viewWorld);
    const glm::vec3 mirror = 2.0f * glm::dot(n, v) * n - v;
    glm::vec3 x = v - n * glm::dot(n, v);
    x = glm::length(x) < 1e-4f ? tangentOf(n) : glm::normalize(x);
    const glm::vec3 y = glm::cross(n, x);
    switch (pick(0, 6)) {
        case 0:
            return glm::normalize(mirror + logUniform(1e-3f, 0.5f) * unitVector());
        case 1: {  // At the surface's horizon.
            const float angle = uniform(0, 6.2831853f);
            return glm::normalize(std::cos(angle) * x + std::sin(angle) * y +
                                  uniform(-0.05f, 0.1f) * n);
        }
        case 2:
        case 3: {  // At a lobe's horizon.
            const double cosView = std::clamp(glm::dot(n, v), 1e-4f, 1.0f);
            using ltc::BuiltinTable;
            const ltc::Table* table = &specularTableOf(model);
            float roughness = pixel.roughness;
            const int which = pick(0, 2);
            if (which == 1 && model.diffuse != Diffuse::lambert) {
                table =
                    &ltc::builtinTable(model.diffuse == Diffuse::burley ? BuiltinTable::burley
                                                                        : BuiltinTable::orenNayar);
            } else if (which > 0 && model.sheen) {
                table = &ltc::builtinTable(BuiltinTable::charlie);
                roughness = pixel.sheenRoughness;
            }
            const ltc::TableEntry entry = table->lookup(roughness, cosView);
            const ltc::Lobe& lobe =
                entry.lobes[static_cast<std::size_t>(pick(0, entry.lobeCount - 1))];
            // In the plane of view the horizon is where m31 x + m33 z = 0.
            glm::vec3 local(lobe.m33, 0, -lobe.m31);
            if (local.z < 0.0f) local = -local;
            local = glm::normalize(local);
            local.y = uniform(-1, 1);
            return glm::normalize(local.x * x + local.y * y + local.z * n +
                                  logUniform(1e-4f, 0.02f) * unitVector());
        }
        default:
            return glm::normalize(unitVector() + 0.7f * n);
    }
}

void BoundCases::addShape(int shape, const glm::vec3& center, const glm::vec3& x,
                          const glm::vec3& y, const glm::vec3& radiance, bool twoSided,
                          LightSet& lights) {
    PolygonLight polygon;
    const auto at = [&](float u, float v) { return center + u * x + v * y; };
    switch (shape) {
        case 0:
            polygon.contours = {{at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)}};
            break;
        case 1:
            polygon.contours = {{at(-1, -1), at(1, -0.5f), at(-0.2f, 1)}};
            break;
        case 2:
        case 6:
            polygon.contours = {
                {at(-1, -1), at(1, -1), at(1, 0.2f), at(0.1f, 0.2f), at(0.1f, 1), at(-1, 1)}};
            if (shape == 2) break;
            polygon.contours.push_back(
                {at(-0.8f, -0.8f), at(-0.8f, -0.2f), at(-0.2f, -0.2f), at(-0.2f, -0.8f)});
            break;
        case 3:
            lights.ellipses.push_back({center, x, y, radiance, twoSided});
            return;
        case 4:
            lights.spheres.push_back({center, glm::length(x), radiance, false});
            return;
        default:
            lights.tubes.push_back({center - x, center + x, glm::length(y), radiance, false});
            return;
    }
    polygon.radiance = radiance;
    polygon.twoSided = twoSided;
    lights.polygons.push_back(std::move(polygon));
}

BoundCase BoundCases::makeCase(std::size_t tile, const std::vector<SurfacePixel>& pixels,
                               const std::vector<std::size_t>& tilePixels,
                               const LightingModel& model) {
    static constexpr std::array kNames = {"rectangle",     "triangle",   "polygon",
                                          "ellipse",       "sphere",     "tube",
                                          "holed polygon", "rectangles", "spheres"};
    BoundCase made;
    made.tile = tile;
    const SurfacePixel& pixel = pixels[tilePixels[static_cast<std::size_t>(
        pick(0, static_cast<int>(tilePixels.size()) - 1))]];
    const float distance = logUniform(0.05f, 200.0f);
    const glm::vec3 direction = directionFrom(pixel, model);
    const glm::vec3 center = pixel.positionWorld + distance * direction;
    const float size = distance * logUniform(1e-3f, pick(0, 3) == 0 ? 1.5f : 0.2f);
    const int shape = pick(0, 8);
    made.shape = kNames[static_cast<std::size_t>(shape)];
    // Most face the surface.
    glm::vec3 normal = glm::normalize(-direction + uniform(0, 1.5f) * unitVector());
    if (pick(0, 4) == 0) {  // Nearly edge-on.
        normal = glm::normalize(tangentOf(direction) + uniform(-0.02f, 0.02f) * direction);
    }
    const bool twoSided = pick(0, 2) == 0;
    const glm::vec3 x = tangentOf(normal);
    const glm::vec3 y = glm::cross(normal, x);
    // Tubes are slender, too.
    const bool isSlender = shape == 5 && pick(0, 2) > 0;
    const float ratio = isSlender         ? logUniform(1e-4f, 0.05f)
                        : pick(0, 1) == 0 ? 1.0f
                                          : uniform(0.05f, 1);
    const glm::vec3 radiance(uniform(1, 10), uniform(1, 10), uniform(1, 10));
    if (shape < 7) {
        addShape(shape, center, size * x, size * ratio * y, radiance, twoSided, made.lights);
    } else {
        const int count = pick(2, 12);
        // As nearly parallel as one key allows, in a plane or at one place.
        const float turn = pick(0, 1) == 0 ? 0.0f : 1.7e-4f;
        const float spread = pick(0, 2) == 0 ? 0.0f : 1.0f;
        const float part = spread == 0.0f ? 1.0f : uniform(0.02f, 0.5f);
        for (int i = 0; i < count; ++i) {
            const glm::vec3 place =
                center + spread * size * (uniform(-1, 1) * x + ratio * uniform(-1, 1) * y);
            const float colors = uniform(0.5f, 2);
            const glm::vec3 turnedX = x + turn * uniform(-1, 1) * normal;
            const glm::vec3 turnedY = y + turn * uniform(-1, 1) * normal;
            addShape(shape == 7 ? 0 : 4, place, part * size * turnedX,
                     part * size * ratio * turnedY, colors * radiance, twoSided, made.lights);
        }
    }
    const LightTree tree =
        buildLightTree(summarizeLights(made.lights, packLights(made.lights).places,
                                       std::vector<float>(made.lights.polygons.size(), 1.0f)),
                       0);
    made.node = tree.nodes.front();
    const std::uint32_t kind = std::bit_cast<std::uint32_t>(made.node.group.z);
    if (kind == shared::kGroupEntry || kind == shared::kLightOrGroupEntry) {
        const float group =
            kind == shared::kLightOrGroupEntry ? made.node.radiance.w : made.node.group.y;
        const shared::ParallelogramData& data = tree.groups[std::bit_cast<std::uint32_t>(group)];
        PolygonLight light;
        const glm::vec3 corner(data.corner), edgeX(data.edgeX), edgeY(data.edgeY);
        light.contours = {{corner, corner + edgeX, corner + edgeX + edgeY, corner + edgeY}};
        light.radiance = glm::vec3(data.radiance);
        light.twoSided = data.corner.w > 0.0f;
        made.group = light;
    }
    made.name =
        concat("at ", distance, " of size ", size, " ratio ", ratio, twoSided ? " two-sided" : "");
    return made;
}

glm::dvec3 reflectAllInDouble(const SurfacePixel& pixel, const LightSet& lights,
                              const LightingModel& model) {
    glm::dvec3 sum(0.0);
    for (const auto& light : lights.polygons) sum += reflectInDouble(pixel, light, model);
    for (const auto& light : lights.ellipses) sum += reflectInDouble(pixel, light, model);
    for (const auto& light : lights.spheres) sum += reflectInDouble(pixel, light, model);
    for (const auto& light : lights.tubes) sum += reflectInDouble(pixel, light, model);
    return sum;
}

}  // namespace polylume::test
