// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/light_check.hpp"

#include <cmath>
#include <string>
#include <string_view>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "lights/texture_check.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

/// The cosine of half axes, and the error of a unit vector's length: more than rounding.
constexpr double kRightAngleTolerance = 1e-3;
constexpr double kUnitTolerance = 1e-3;

std::string describe(const glm::vec3& v) {
    return concat("(", v.x, ", ", v.y, ", ", v.z, ")");
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void checkPower(const glm::vec3& power, std::string_view name, std::string_view kind,
                std::size_t index) {
    const glm::vec3 most(kLargestEmission);
    if (glm::all(glm::greaterThanEqual(power, glm::vec3(0.0f))) &&
        glm::all(glm::lessThanEqual(power, most)))
        return;
    throw Error(concat("expected ", name, " of ", kind, " light ", index, " to be from 0 to ",
                       kLargestEmission, ", found (", power.x, ", ", power.y, ", ", power.z, ")"));
}

/// KHR_lights_punctual has inner below outer; as both are the same here the edge is hard.
void checkCone(const PunctualLight& light, std::size_t index) {
    const float inner = light.innerConeAngle;
    const float outer = light.outerConeAngle;
    // A right angle in float lies just above it.
    const bool isCone = inner >= 0.0f && inner <= outer && outer <= 1.570797f;
    if (isCone) return;
    throw Error(
        concat("expected 0 <= innerConeAngle <= outerConeAngle <= pi / 2, in radians, of "
               "punctual light ",
               index, ", found ", inner, " and ", outer));
}

template <typename Light>
void checkEach(const std::vector<Light>& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i) checkLight(lights[i], i);
}

}  // namespace

void checkLight(const PolygonLight& light, std::size_t index, PolygonCheckStorage& storage,
                bool withImage) {
    checkPower(light.radiance, "radiance", "polygon", index);
    std::size_t vertexCount = 0;
    for (const auto& contour : light.contours) vertexCount += contour.size();
    if (vertexCount > kMostPolygonVertices) {
        throw Error(concat("expected polygon light ", index, " to have at most ",
                           kMostPolygonVertices, " vertices, found ", vertexCount,
                           ": leave some out or split it"));
    }
    if (light.contours.empty()) {
        throw Error(concat("expected polygon light ", index, " to have a contour, found none"));
    }
    for (const auto& contour : light.contours) {
        if (contour.size() < 3) {
            throw Error(concat("expected a contour of polygon light ", index,
                               " to have 3 vertices or more, found ", contour.size()));
        }
        for (const glm::vec3& vertex : contour) {
            if (!isFinite(vertex)) {
                throw Error(concat("expected finite vertices in polygon light ", index, ", found (",
                                   vertex.x, ", ", vertex.y, ", ", vertex.z, ")"));
            }
        }
    }
    checkContours(light, index, storage);
    if (!light.texture) return;
    if (withImage) checkLightImage(light, index);
    checkTextureAxes(light, index);
}

void checkLight(const EllipseLight& light, std::size_t index) {
    checkPower(light.radiance, "radiance", "ellipse", index);
    if (!isFinite(light.center) || !isFinite(light.halfAxisX) || !isFinite(light.halfAxisY)) {
        throw Error(
            concat("expected a finite centre and finite half axes of ellipse light ", index));
    }
    const glm::dvec3 x(light.halfAxisX), y(light.halfAxisY);
    const double lengths = glm::length(x) * glm::length(y);
    if (std::abs(glm::dot(x, y)) <= kRightAngleTolerance * lengths) return;
    throw Error(concat("expected the half axes of ellipse light ", index,
                       " to be at right angles, within a thousandth, found ",
                       describe(light.halfAxisX), " and ", describe(light.halfAxisY),
                       ", with a cosine of ", glm::dot(x, y) / lengths));
}

void checkLight(const SphereLight& light, std::size_t index) {
    checkPower(light.radiance, "radiance", "sphere", index);
    if (isFinite(light.center) && light.radius >= 0.0f && std::isfinite(light.radius)) return;
    throw Error(concat("expected a finite centre and a finite radius of 0 or more of sphere light ",
                       index, ", found a radius of ", light.radius));
}

void checkLight(const TubeLight& light, std::size_t index) {
    checkPower(light.radiance, "radiance", "tube", index);
    if (isFinite(light.start) && isFinite(light.end) && light.radius >= 0.0f &&
        std::isfinite(light.radius)) {
        return;
    }
    throw Error(concat("expected finite ends and a finite radius of 0 or more of tube light ",
                       index, ", found a radius of ", light.radius));
}

void checkLight(const PunctualLight& light, std::size_t index) {
    checkPower(light.intensity, "intensity", "punctual", index);
    if (!isFinite(light.position) || !isFinite(light.direction)) {
        throw Error(concat("expected a finite position and direction of punctual light ", index));
    }
    const double length = glm::length(glm::dvec3(light.direction));
    if (light.kind != PunctualLightKind::point && !(std::abs(length - 1.0) <= kUnitTolerance)) {
        throw Error(concat("expected the direction of punctual light ", index,
                           " to be of length 1, found ", describe(light.direction), " of length ",
                           length, ": normalize it"));
    }
    if (!(light.range > 0.0f)) {
        throw Error(concat("expected the range of punctual light ", index,
                           " to be above 0, and infinite for none, found ", light.range));
    }
    if (light.kind == PunctualLightKind::spot) checkCone(light, index);
}

void checkLights(const LightSet& lights) {
    PolygonCheckStorage storage;
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        checkLight(lights.polygons[i], i, storage);
    }
    checkEach(lights.ellipses);
    checkEach(lights.spheres);
    checkEach(lights.tubes);
    checkEach(lights.punctuals);
}

}  // namespace polylume
