// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "lighting/light_packing.hpp"
#include "polylume/light.hpp"

namespace polylume {

/// Some of a flat light's area at a point.
struct AreaSample {
    glm::dvec3 position{0.0};
    double area = 0.0;  ///< May be negative.
};

/// What bounds a light's contribution, and what a group of lights is made from.
struct LightSummary {
    LightPlace place;
    glm::dvec3 center{0.0};
    double radius = 0.0;     ///< Of a sphere about `center` that holds the light.
    glm::dvec3 normal{0.0};  ///< Unit, of a flat light; else 0.
    double offPlane = 0.0;   ///< Largest distance of a point of a flat light from its plane.
    bool twoSided = false;
    double area = 0.0;         ///< Of what a far point sees, at most.
    glm::dvec3 radiance{0.0};  ///< Largest of any point, nits; kUnbounded where it is not known.
    double range = 1e30;       ///< It gives nothing to points that are farther away.
    glm::dvec3 axis{0.0};      ///< Of a tube, from its start to its end,
    double tubeRadius = 0.0;   ///< and its radius; a ball is a tube without length.
    /// Of an even flat light: sums over them equal integrals over its area for polynomials up to
    /// the third degree. Else empty.
    std::vector<AreaSample> samples;

    static constexpr double kUnbounded = 1e30;
};

/// Of all lights with a kind. `brightestTexels` holds for each of the polygon lights the largest
/// factor in its image.
std::vector<LightSummary> summarizeLights(const LightSet& lights, const LightPlaces& places,
                                          const std::vector<float>& brightestTexels);

}  // namespace polylume
