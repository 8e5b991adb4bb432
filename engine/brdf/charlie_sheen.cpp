// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/charlie_sheen.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/hemisphere.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

/// Where Lambda changes from one form to the other: its second derivative jumps.
constexpr double kSplitCosine = 0.5;

double logLambda(double x, double alpha) {
    const double t = (1.0 - alpha) * (1.0 - alpha);
    const double a = std::lerp(21.5473, 25.3245, t);
    const double b = std::lerp(3.82987, 3.32435, t);
    const double c = std::lerp(0.19823, 0.16801, t);
    const double d = std::lerp(-1.97760, -1.27393, t);
    const double e = std::lerp(-4.32054, -4.85967, t);
    return a / (1.0 + b * std::pow(x, c)) + d * x + e;
}

/// The power of (1 - z) that about follows the lobe's rise toward the horizon: at the normal view D
/// is (1 - z)^(1 / (2 alpha)), at a grazing one a Gaussian of width 2 sqrt(alpha).
double horizonPower(const glm::dvec3& view, double alpha) {
    return std::lerp(0.5 / std::sqrt(alpha), 0.5 / alpha, view.z);
}

/// A rule of `count` nodes for the angle to the normal. Those below the split are laid as a Gauss
/// rule; beyond it they crowd at the horizon, where Lambda rises without a finite slope.
std::vector<QuadratureNode> thetaRule(int count) {
    const double split = std::acos(kSplitCosine);
    const double rest = 0.5 * kPi - split;
    std::vector<QuadratureNode> rule;
    for (const QuadratureNode& node : gaussLegendre(std::max(1, count / 2))) {
        const double square = node.position * node.position;
        rule.push_back({split * node.position, split * node.weight});
        rule.push_back(
            {0.5 * kPi - rest * square * node.position, rest * 3.0 * square * node.weight});
    }
    return rule;
}

}  // namespace

double charlieAlpha(double roughness) {
    return std::clamp(roughness * roughness, CharlieSheen::kAlphaFloor, 1.0);
}

double charlieDistribution(const glm::dvec3& halfVector, double alpha) {
    const double sineSquare = halfVector.x * halfVector.x + halfVector.y * halfVector.y;
    return (2.0 + 1.0 / alpha) * std::pow(sineSquare, 0.5 / alpha) / (2.0 * kPi);
}

double charlieLambda(double cosTheta, double alpha) {
    if (cosTheta < kSplitCosine) return std::exp(logLambda(cosTheta, alpha));
    return std::exp(2.0 * logLambda(kSplitCosine, alpha) -
                    logLambda(std::max(0.0, 1.0 - cosTheta), alpha));
}

double CharlieSheen::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                              double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const double alpha = charlieAlpha(roughness);
    const double masking =
        1.0 / (1.0 + charlieLambda(view.z, alpha) + charlieLambda(light.z, alpha));
    return charlieDistribution(glm::normalize(view + light), alpha) * masking / (4.0 * view.z);
}

glm::dvec3 CharlieSheen::sample(const glm::dvec3& view, double roughness,
                                const glm::dvec2& random) const {
    if (random.x < 0.5) return directionAtHeight(1.0 - 2.0 * random.x, random.y);
    const double power = horizonPower(view, charlieAlpha(roughness));
    const double share = 2.0 * (1.0 - random.x);
    return directionAtHeight(-std::expm1(std::log(share) / (power + 1.0)), random.y);
}

double CharlieSheen::density(const glm::dvec3& view, const glm::dvec3& light,
                             double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const double power = horizonPower(view, charlieAlpha(roughness));
    const double rising = (power + 1.0) * std::pow(std::max(0.0, 1.0 - light.z), power);
    return (0.5 + 0.5 * rising) / (2.0 * kPi);
}

std::vector<HemispherePoint> CharlieSheen::quadrature(const glm::dvec3& /*view*/,
                                                      double /*roughness*/, int resolution) const {
    return polarRule(thetaRule(resolution),
                     spreadBetween(crowdedGaussLegendre, std::max(1, resolution / 2), {0.0, kPi}));
}

Reflectance CharlieSheen::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 96;
    const glm::dvec3 view = viewDirection(cosThetaView);
    return sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
}

}  // namespace polylume::brdf
