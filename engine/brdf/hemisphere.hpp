// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "brdf/brdf.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {

/// The unit direction at the height `z` in [0, 1] above the surface, `turn` of a full turn from x.
glm::dvec3 directionAtHeight(double z, double turn);

/// A direction of density light.z / pi, from `random` in [0, 1)^2.
glm::dvec3 sampleCosine(const glm::dvec2& random);

/// The density of sampleCosine(): 0 below the surface.
double cosineDensity(const glm::dvec3& light);

/// The mean of the cosine density and of the even one, 1 / (2 pi): bounds the weights of BRDFs that
/// grow toward the horizon.
glm::dvec3 sampleCosineOrEven(const glm::dvec2& random);
double cosineOrEvenDensity(const glm::dvec3& light);

/// The product of a rule for the angle to the normal, within [0, pi/2], and one for the azimuth
/// from the x axis, [0, pi], as Brdf::quadrature() has to give.
std::vector<HemispherePoint> polarRule(const std::vector<QuadratureNode>& thetas,
                                       const std::vector<QuadratureNode>& azimuths);

/// The sums that Brdf::reflectance() returns, over the points of a rule.
Reflectance sumReflectance(const Brdf& brdf, const glm::dvec3& view, double roughness,
                           const std::vector<HemispherePoint>& points);

}  // namespace polylume::brdf
