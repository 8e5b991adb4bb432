// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/burley_diffuse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/hemisphere.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

double fifthPower(double x) {
    const double square = x * x;
    return square * square * x;
}

}  // namespace

double BurleyDiffuse::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                               double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    // 2 cos^2(theta_d) = 1 + v.l.
    const double grazing = roughness * (1.0 + glm::dot(view, light)) - 0.5;
    return (1.0 + grazing * fifthPower(1.0 - light.z)) *
           (1.0 + grazing * fifthPower(1.0 - view.z)) * light.z / kPi;
}

glm::dvec3 BurleyDiffuse::sample(const glm::dvec3& /*view*/, double /*roughness*/,
                                 const glm::dvec2& random) const {
    return sampleCosine(random);
}

double BurleyDiffuse::density(const glm::dvec3& view, const glm::dvec3& light,
                              double /*roughness*/) const {
    return view.z > 0.0 ? cosineDensity(light) : 0.0;
}

std::vector<HemispherePoint> BurleyDiffuse::quadrature(const glm::dvec3& /*view*/,
                                                       double /*roughness*/, int resolution) const {
    return polarRule(spreadBetween(gaussLegendre, resolution, {0.0, 0.5 * kPi}),
                     spreadBetween(gaussLegendre, std::max(1, resolution / 2), {0.0, kPi}));
}

Reflectance BurleyDiffuse::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 64;
    const glm::dvec3 view = viewDirection(cosThetaView);
    return sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
}

}  // namespace polylume::brdf
