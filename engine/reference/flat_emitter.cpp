// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/flat_emitter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/light_image_sampling.hpp"
#include "lights/light_outline.hpp"
#include "lights/plane_axes.hpp"

namespace polylume::reference {
namespace {

/// Sides of the polygon around an ellipse that is sampled in its place; 1.3 % of the samples miss.
constexpr int kEllipseSides = 16;

/// A polygon of more vertices would have thousands of parts: its convex hull is sampled in its
/// place.
constexpr std::size_t kMostVertices = 128;

bool isRectangle(const PolygonLight& light) {
    if (light.contours.size() != 1 || light.contours.front().size() != 4) return false;
    const std::vector<glm::vec3>& c = light.contours.front();
    const glm::dvec3 x = glm::dvec3(c[1]) - glm::dvec3(c[0]);
    const glm::dvec3 y = glm::dvec3(c[3]) - glm::dvec3(c[0]);
    const glm::dvec3 gap = glm::dvec3(c[2]) - glm::dvec3(c[1]) - y;
    const double size = std::max(glm::length(x), glm::length(y));
    // Corners rounded to float are off by their distance from the origin.
    const double rounding = 1e-6 * size + 2e-7 * glm::length(glm::dvec3(c[2]));
    return glm::length(gap) <= rounding &&
           std::abs(glm::dot(x, y)) <= rounding * std::max(glm::length(x), glm::length(y));
}

/// None where the light's points have no coordinates that tell texels apart: those of axes that are
/// parallel, or far beyond the picture.
std::optional<EmitterTexture> textureOf(const LightTexture& texture, const FlatEmitter& emitter) {
    constexpr double kFarthest = 1e9;
    EmitterTexture result{texture, textureCoordinates(texture, emitter.origin)};
    result.perX = textureCoordinates(texture, emitter.origin + emitter.axisX) - result.origin;
    result.perY = textureCoordinates(texture, emitter.origin + emitter.axisY) - result.origin;
    for (const PlanarContour& part : emitter.parts) {
        for (const glm::dvec2& vertex : part) {
            const glm::dvec2 place =
                glm::abs(result.origin + vertex.x * result.perX + vertex.y * result.perY);
            if (!(place.x < kFarthest && place.y < kFarthest)) return std::nullopt;
        }
    }
    return result;
}

/// Of any outline that is no rectangle, from the normal and the origin on.
void setPolygon(FlatEmitter& emitter, const PolygonLight& light) {
    const PlaneAxes axes(emitter.normal);
    emitter.axisX = axes.x;
    emitter.axisY = axes.y;
    for (const std::vector<glm::vec3>& contour : light.contours) {
        PlanarContour& planar = emitter.contours.emplace_back();
        for (const glm::vec3& vertex : contour) {
            const glm::dvec3 offset = glm::dvec3(vertex) - emitter.origin;
            planar.emplace_back(glm::dot(offset, emitter.axisX), glm::dot(offset, emitter.axisY));
        }
    }
    std::size_t vertexCount = 0;
    for (const PlanarContour& contour : emitter.contours) vertexCount += contour.size();
    emitter.isCoveredWidely = vertexCount > kMostVertices;
    emitter.parts = emitter.isCoveredWidely
                        ? std::vector<PlanarContour>{convexHull(emitter.contours.front())}
                        : convexParts(emitter.contours);
    for (const PlanarContour& part : emitter.parts) emitter.area += area(part);
}

}  // namespace

FlatEmitter flatEmitter(const PolygonLight& light) {
    FlatEmitter emitter;
    const std::vector<glm::vec3>& outline = light.contours.front();
    const glm::dvec3 normal = areaVector(outline);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return emitter;
    emitter.normal = normal / length;
    emitter.radiance = light.radiance;
    emitter.shownBySurface = light.shownBySurface;
    emitter.twoSided = light.twoSided;
    emitter.origin = outline.front();
    if (isRectangle(light)) {
        emitter.shape = FlatEmitter::Shape::rectangle;
        emitter.axisX = glm::dvec3(outline[1]) - emitter.origin;
        emitter.axisY = glm::dvec3(outline[3]) - emitter.origin;
        emitter.parts = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        emitter.area = glm::length(emitter.axisX) * glm::length(emitter.axisY);
    } else {
        setPolygon(emitter, light);
    }
    if (light.texture) emitter.texture = textureOf(*light.texture, emitter);
    return emitter;
}

FlatEmitter flatEmitter(const EllipseLight& light) {
    FlatEmitter emitter;
    emitter.shape = FlatEmitter::Shape::ellipse;
    emitter.isCoveredWidely = true;
    emitter.origin = light.center;
    emitter.axisX = light.halfAxisX;
    emitter.axisY = light.halfAxisY;
    const glm::dvec3 normal = glm::cross(emitter.axisX, emitter.axisY);
    const double length = glm::length(normal);
    if (!(length > 0.0)) return emitter;
    emitter.normal = normal / length;
    emitter.radiance = light.radiance;
    emitter.twoSided = light.twoSided;
    emitter.area = std::numbers::pi * length;
    const double step = 2.0 * std::numbers::pi / kEllipseSides;
    PlanarContour& part = emitter.parts.emplace_back();
    for (int i = 0; i < kEllipseSides; ++i) {
        part.push_back(glm::dvec2(std::cos(step * i), std::sin(step * i)) / std::cos(0.5 * step));
    }
    return emitter;
}

bool FlatEmitter::contains(const glm::dvec2& planar) const {
    switch (shape) {
        case Shape::rectangle:
            return planar.x >= 0.0 && planar.x <= 1.0 && planar.y >= 0.0 && planar.y <= 1.0;
        case Shape::ellipse:
            return glm::dot(planar, planar) <= 1.0;
        case Shape::polygon:
            break;
    }
    return isInside(contours, planar);
}

std::optional<double> FlatEmitter::intersect(const glm::dvec3& rayOrigin,
                                             const glm::dvec3& direction) const {
    const glm::dvec3 offset = origin - rayOrigin;
    const double distance = glm::dot(offset, normal) / glm::dot(direction, normal);
    if (!(distance > 0.0) || !std::isfinite(distance)) return std::nullopt;
    const glm::dvec3 point = distance * direction - offset;
    return contains(planarCoordinates(point, axisX, axisY)) ? std::optional(distance)
                                                            : std::nullopt;
}

}  // namespace polylume::reference
