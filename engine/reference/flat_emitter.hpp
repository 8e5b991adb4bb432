// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "lights/light_image_sampling.hpp"
#include "polylume/light.hpp"
#include "reference/planar_outline.hpp"

namespace polylume::reference {

/// Where `point`, from an origin in the plane of two axes at right angles, lies along them in their
/// lengths.
inline glm::dvec2 planarCoordinates(const glm::dvec3& point, const glm::dvec3& axisX,
                                    const glm::dvec3& axisY) {
    return {glm::dot(point, axisX) / glm::dot(axisX, axisX),
            glm::dot(point, axisY) / glm::dot(axisY, axisY)};
}

/// A picture on a flat light, by the light's own planar coordinates.
struct EmitterTexture {
    LightTexture texture;
    glm::dvec2 origin{0.0}, perX{0.0}, perY{0.0};  ///< Texture coordinates.

    glm::dvec3 at(const glm::dvec2& planar) const {
        return sampleImage(texture, origin + planar.x * perX + planar.y * perY);
    }
};

/// A flat light, prepared for being hit by rays and sampled. Points of its plane are
/// origin + x axisX + y axisY.
struct FlatEmitter {
    enum class Shape { rectangle, polygon, ellipse };

    Shape shape = Shape::polygon;
    glm::dvec3 origin{0.0};
    /// Of a rectangle its edges, of an ellipse its half axes, else unit; at right angles.
    glm::dvec3 axisX{1.0, 0.0, 0.0}, axisY{0.0, 1.0, 0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< Unit, to the emitting side.
    double area = 0.0;         ///< Of what is sampled: of the light, or of wide parts of a polygon.
    glm::dvec3 radiance{0.0};  ///< Nits.
    bool twoSided = false;
    bool shownBySurface = false;  ///< The camera does not see it.
    std::optional<EmitterTexture> texture;
    std::vector<PlanarContour> contours;  ///< Of a polygon.
    /// Convex, counter-clockwise; cover the shape without overlap.
    std::vector<PlanarContour> parts;
    bool isCoveredWidely = false;  ///< The parts reach beyond it.

    /// Whether `offset` from the light to a point is on a side that it emits to.
    bool emitsToward(const glm::dvec3& offset) const {
        const double height = glm::dot(offset, normal);
        return twoSided ? height != 0.0 : height > 0.0;
    }

    /// Whether the light has the point of its plane.
    bool contains(const glm::dvec2& planar) const;

    /// Nits.
    glm::dvec3 radianceAt(const glm::dvec2& planar) const {
        return texture ? radiance * texture->at(planar) : radiance;
    }

    /// The distance in units of `direction` at which a ray meets the light, from either side.
    std::optional<double> intersect(const glm::dvec3& rayOrigin, const glm::dvec3& direction) const;
};

/// Without an area where `light` has none.
FlatEmitter flatEmitter(const PolygonLight& light);
FlatEmitter flatEmitter(const EllipseLight& light);

}  // namespace polylume::reference
