// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Making a light of one kind into one of another, and how much light it gives.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "light_editor_shapes.hpp"
#include "lights/light_outline.hpp"

namespace polylume::viewer {
namespace {

using scene::AreaLight;
using PunctualSource = scene::PunctualLight;
using scene::PunctualLightType;

constexpr double kPi = std::numbers::pi;

/// Of a light without extent that gets one.
constexpr double kNewHalfExtent = 0.25;

scene::LightFrame frameOf(const LightBox& box) {
    return {glm::vec3(box.center), glm::mat3(box.axes)};
}

/// Square metres that shine, and how many sides.
double areaOf(const AreaLight& light) {
    struct Area {
        double operator()(const PolygonLight& shape) const {
            double area = 0.0;
            const glm::dvec3 outline = areaVector(shape.contours.front());
            if (!(glm::length(outline) > 0.0)) return 0.0;
            for (const auto& contour : shape.contours) {
                area += 0.5 * glm::dot(areaVector(contour), glm::normalize(outline));
            }
            return area;
        }
        double operator()(const EllipseLight& shape) const {
            return kPi * glm::length(glm::dvec3(shape.halfAxisX)) *
                   glm::length(glm::dvec3(shape.halfAxisY));
        }
        double operator()(const SphereLight& shape) const {
            return 4.0 * kPi * shape.radius * shape.radius;
        }
        double operator()(const TubeLight& shape) const {
            const double length = glm::length(glm::dvec3(shape.end) - glm::dvec3(shape.start));
            return 2.0 * kPi * shape.radius * (length + 2.0 * shape.radius);
        }
    };
    return std::visit(Area{}, light.shape);
}

/// Lumens per unit of emission; lights to all sides give what they would without obstacles.
double fluxPerEmission(const AnyLight& light) {
    if (const auto* area = std::get_if<AreaLight>(&light)) {
        // Both sides of a flat light shine into the world, the inside of a round one does not.
        const double sides = isFlat(kindOf(light)) && isTwoSided(light) ? 2.0 : 1.0;
        return kPi * areaOf(*area) * sides;
    }
    const auto& punctual = std::get<PunctualSource>(light);
    if (punctual.type == PunctualLightType::spot) {
        // Between the cones it falls off; halfway stands for it.
        const double cosine =
            0.5 * (std::cos(punctual.innerConeAngle) + std::cos(punctual.outerConeAngle));
        return 2.0 * kPi * (1.0 - cosine);
    }
    return 4.0 * kPi;
}

/// Candela toward the front, or of round lights to any side, per unit of emission; lux of a
/// directional light count as candela at a metre.
double axialPerEmission(const AnyLight& light) {
    const auto* area = std::get_if<AreaLight>(&light);
    if (area == nullptr) return 1.0;
    const double surface = areaOf(*area);
    switch (kindOf(light)) {
        case LightKind::sphere:
            return surface / 4.0;  // Its disk.
        case LightKind::tube:
            return surface / kPi;  // About its outline from the side.
        default:
            return surface;
    }
}

bool shinesAllAround(const AnyLight& light) {
    const LightKind kind = kindOf(light);
    return kind == LightKind::sphere || kind == LightKind::tube || kind == LightKind::point;
}

}  // namespace

AnyLight converted(const AnyLight& light, LightKind kind, const glm::dmat3& axes) {
    if (kind == kindOf(light)) return light;
    LightBox box = boxOf(light, axes);
    box.axes = axes;
    if (!(std::max(box.half.x, box.half.y) > 0.0)) box.half = glm::dvec3(kNewHalfExtent);
    const double larger = std::max(box.half.x, box.half.y);
    const double smaller = std::max(std::min(box.half.x, box.half.y), kLeastExtent);
    const glm::vec2 size(2.0 * glm::dvec2(box.half));
    const glm::vec3 emission(1.0f);
    AreaLight area{nameOf(light), {}, ""};
    AnyLight result;
    switch (kind) {
        case LightKind::rectangle:
            area.shape = scene::makeRectangle(frameOf(box), size, emission);
            result = area;
            break;
        case LightKind::polygon:
            area.shape = PolygonLight{};
            result = withCorners(area, 6, box);
            break;
        case LightKind::ellipse:
            area.shape = scene::makeEllipse(frameOf(box), size, emission);
            result = area;
            break;
        case LightKind::sphere:
            area.shape = SphereLight{glm::vec3(box.center), static_cast<float>(larger)};
            result = area;
            break;
        case LightKind::tube: {
            // Along the longer of the two, as thick as a quarter of what was square.
            LightBox tube = box;
            if (box.half.y > box.half.x) {
                tube.axes = glm::dmat3(box.axes[1], -box.axes[0], box.axes[2]);
            }
            const double radius = std::min(smaller, 0.25 * larger);
            area.shape = scene::makeTube(frameOf(tube), static_cast<float>(2.0 * (larger - radius)),
                                         static_cast<float>(radius), emission);
            result = area;
            break;
        }
        case LightKind::directional:
        case LightKind::point:
        case LightKind::spot: {
            PunctualSource punctual;
            punctual.name = nameOf(light);
            punctual.type = kind == LightKind::directional ? PunctualLightType::directional
                            : kind == LightKind::point     ? PunctualLightType::point
                                                           : PunctualLightType::spot;
            punctual.position = glm::vec3(box.center);
            punctual.direction = glm::normalize(-glm::vec3(axes[2]));
            result = punctual;
            break;
        }
    }
    setTwoSided(result, isTwoSided(light) && isFlat(kind));
    if (kind == LightKind::rectangle || kind == LightKind::polygon) {
        setPicture(std::get<AreaLight>(result), pictureOf(light), box);
    }
    const bool byFlux = shinesAllAround(light) == shinesAllAround(result) &&
                        kind != LightKind::directional && kindOf(light) != LightKind::directional &&
                        isArea(kind) && isArea(kindOf(light));
    const double before = byFlux ? fluxPerEmission(light) : axialPerEmission(light);
    const double after = byFlux ? fluxPerEmission(result) : axialPerEmission(result);
    const double factor = after > 0.0 ? before / after : 1.0;
    setEmission(result, glm::vec3(factor * glm::dvec3(emissionOf(light))));
    return result;
}

AreaLight withCorners(const AreaLight& light, int corners, const LightBox& box) {
    AreaLight result = light;
    auto& polygon = std::get<PolygonLight>(result.shape);
    // The first edge is at -X and goes up, as a rectangle's; the outline fills the box.
    std::vector<glm::dvec2> outline;
    glm::dvec2 low(INFINITY), high(-INFINITY);
    for (int i = 0; i < corners; ++i) {
        const double angle = kPi + kPi / corners - 2.0 * kPi * i / corners;
        outline.emplace_back(std::cos(angle), std::sin(angle));
        low = glm::min(low, outline.back());
        high = glm::max(high, outline.back());
    }
    polygon.contours = {{}};
    polygon.shownBySurface = false;
    for (const glm::dvec2& corner : outline) {
        const glm::dvec2 share = 2.0 * (corner - low) / (high - low) - 1.0;
        polygon.contours[0].emplace_back(box.center +
                                         box.axes * glm::dvec3(share * glm::dvec2(box.half), 0.0));
    }
    return result;
}

std::optional<double> fluxOf(const AnyLight& light) {
    if (kindOf(light) == LightKind::directional) return std::nullopt;
    const glm::dvec3 emission(emissionOf(light));
    return fluxPerEmission(light) * glm::dot(emission, glm::dvec3(0.2126, 0.7152, 0.0722));
}

}  // namespace polylume::viewer
