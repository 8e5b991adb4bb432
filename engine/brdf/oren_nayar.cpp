// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/oren_nayar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/hemisphere.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

struct Coefficients {
    double even;        // A
    double retrograde;  // B
};

Coefficients coefficients(double roughness) {
    const double variance = roughness * roughness;
    return {1.0 - 0.5 * variance / (variance + 0.33), 0.45 * variance / (variance + 0.09)};
}

}  // namespace

double OrenNayar::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                           double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const auto [even, retrograde] = coefficients(roughness);
    // cos(phi) sin(a) tan(b) = (v.l in the plane) / max(v.z, l.z).
    const double planar = std::max(0.0, view.x * light.x + view.y * light.y);
    return (even + retrograde * planar / std::max(view.z, light.z)) * light.z / kPi;
}

glm::dvec3 OrenNayar::sample(const glm::dvec3& /*view*/, double /*roughness*/,
                             const glm::dvec2& random) const {
    return sampleCosineOrEven(random);
}

double OrenNayar::density(const glm::dvec3& view, const glm::dvec3& light,
                          double /*roughness*/) const {
    return view.z > 0.0 ? cosineOrEvenDensity(light) : 0.0;
}

std::vector<HemispherePoint> OrenNayar::quadrature(const glm::dvec3& view, double /*roughness*/,
                                                   int resolution) const {
    const double viewTheta = std::atan2(std::hypot(view.x, view.y), view.z);
    return polarRule(spreadBetween(gaussLegendre, resolution, {0.0, viewTheta, 0.5 * kPi}),
                     spreadBetween(gaussLegendre, resolution / 2, {0.0, 0.5 * kPi, kPi}));
}

Reflectance OrenNayar::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 64;
    const glm::dvec3 view = viewDirection(cosThetaView);
    Reflectance sum =
        sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
    // The integral of max(0, cos phi) sin(a) tan(b) cos(theta_l), first below, then above theta_v.
    const auto [even, retrograde] = coefficients(roughness);
    const double sine = view.x;
    const double theta = std::atan2(sine, view.z);
    const double steeper = sine * (theta - sine * view.z);
    // (1 - sin^3) / cos without its cancellation.
    const double flatter = sine * view.z * (1.0 + sine + sine * sine) / (1.0 + sine) * (2.0 / 3.0);
    sum.albedo = even + retrograde / kPi * (steeper + flatter);
    return sum;
}

}  // namespace polylume::brdf
