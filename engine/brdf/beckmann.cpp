// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/beckmann.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brdf/hemisphere.hpp"
#include "brdf/reflection_domain.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInvSqrtPi = std::numbers::inv_sqrtpi;

/// Slopes beyond this have a probability below 1e-18.
constexpr double kLargestSlope = 6.4;

/// The root in [low, high] of a growing function by Newton's steps from `x`, bisecting where one
/// leaves the bracket. `function` returns the value and the derivative.
template <typename Function>
double solveGrowing(double low, double high, double x, const Function& function) {
    x = std::clamp(x, low, high);
    for (int iteration = 0; iteration < 100; ++iteration) {
        const auto [value, derivative] = function(x);
        (value > 0.0 ? high : low) = x;
        const double step = x - value / derivative;
        // Written so that the NaN of 0 / 0 bisects too.
        const double next = step >= low && step <= high ? step : 0.5 * (low + high);
        // The next step's error is about the square of this one's.
        if (std::abs(next - x) < 1e-9) return next;
        x = next;
    }
    return x;
}

/// The inverse of erf within 0.005, the start of a search (Winitzki 2008, eq. 7), of 2 share - 1.
double estimateInverseErf(double share) {
    constexpr double kShape = 0.147;
    const double logarithm = std::log(std::max(4.0 * share * (1.0 - share), 1e-18));
    const double middle = 2.0 / (kPi * kShape) + 0.5 * logarithm;
    const double square = std::sqrt(middle * middle - logarithm / kShape) - middle;
    return std::copysign(std::sqrt(std::max(0.0, square)), share - 0.5);
}

/// One slope of a surface of unit roughness, of density exp(-s^2) / sqrt(pi).
double sampleSlope(double random) {
    const double start = estimateInverseErf(random);
    return solveGrowing(-kLargestSlope, kLargestSlope, start, [&](double s) {
        // By the smaller tail, which keeps its digits.
        const double value =
            s < 0.0 ? 0.5 * std::erfc(-s) - random : (1.0 - random) - 0.5 * std::erfc(s);
        return std::pair(value, kInvSqrtPi * std::exp(-s * s));
    });
}

/// The slope along the view's azimuth, toward the view, as seen by a unit direction at (sine,
/// cosine) to the normal: density (cosine + s sine) exp(-s^2) / sqrt(pi) for s > -cosine / sine, up
/// to its norm (Heitz and d'Eon 2014, section 4).
double sampleVisibleSlope(double sine, double cosine, double random) {
    const double low = sine * kLargestSlope > cosine ? -cosine / sine : -kLargestSlope;
    // The share above s, not normalised: (cosine erfc(s) + sine exp(-s^2) / sqrt(pi)) / 2.
    const auto above = [&](double s) {
        return 0.5 * (cosine * std::erfc(s) + sine * kInvSqrtPi * std::exp(-s * s));
    };
    const double target = random * above(low);
    // Exact at the normal view and at a grazing one.
    const double start = std::lerp(std::sqrt(-std::log(std::max(random, 1e-18))),
                                   -estimateInverseErf(random), cosine);
    return solveGrowing(low, kLargestSlope, start, [&](double s) {
        return std::pair(target - above(s), (cosine + s * sine) * kInvSqrtPi * std::exp(-s * s));
    });
}

}  // namespace

double beckmannAlpha(double roughness) {
    return std::clamp(roughness * roughness, Beckmann::kAlphaFloor, 1.0);
}

double beckmannDistribution(const glm::dvec3& halfVector, double alpha) {
    if (halfVector.z <= 0.0) return 0.0;
    const double planar = halfVector.x * halfVector.x + halfVector.y * halfVector.y;
    const double square = halfVector.z * halfVector.z;
    const double exponent = planar / (alpha * alpha * square);
    // Below what a double holds, and 0 / 0 soon.
    if (!(exponent < 700.0)) return 0.0;
    return std::exp(-exponent) / (kPi * alpha * alpha * square * square);
}

double beckmannLambda(const glm::dvec3& direction, double alpha) {
    const double planar = std::hypot(direction.x, direction.y);
    // exp(-a^2) is below 1e-300 there.
    if (direction.z > 26.0 * alpha * planar) return 0.0;
    const double a = direction.z / (alpha * planar);
    return std::max(0.0, 0.5 * (kInvSqrtPi * std::exp(-a * a) / a - std::erfc(a)));
}

double Beckmann::evaluate(const glm::dvec3& view, const glm::dvec3& light, double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const double alpha = beckmannAlpha(roughness);
    const double masking = 1.0 / (1.0 + beckmannLambda(view, alpha) + beckmannLambda(light, alpha));
    return beckmannDistribution(glm::normalize(view + light), alpha) * masking / (4.0 * view.z);
}

glm::dvec3 Beckmann::sample(const glm::dvec3& view, double roughness,
                            const glm::dvec2& random) const {
    const double alpha = beckmannAlpha(roughness);
    // The view direction as seen by the surface of unit roughness.
    const double planar = std::hypot(view.x, view.y);
    const double length = std::hypot(alpha * planar, view.z);
    // Slopes toward the view's azimuth and across it. The normal leans by plus the slope here.
    const double along =
        alpha * sampleVisibleSlope(alpha * planar / length, view.z / length, random.x);
    const double across = alpha * sampleSlope(random.y);
    const glm::dvec2 azimuth =
        planar > 0.0 ? glm::dvec2(view.x, view.y) / planar : glm::dvec2(1, 0);
    const glm::dvec3 half = glm::normalize(glm::dvec3(along * azimuth.x - across * azimuth.y,
                                                      along * azimuth.y + across * azimuth.x, 1.0));
    return 2.0 * glm::dot(view, half) * half - view;
}

double Beckmann::density(const glm::dvec3& view, const glm::dvec3& light, double roughness) const {
    const glm::dvec3 sum = view + light;
    if (view.z <= 0.0 || sum.z <= 0.0) return 0.0;
    const double alpha = beckmannAlpha(roughness);
    // Visible normals D_v(h) = G1 (v.h) D / v.z, over the 4 (v.h) of the reflection.
    const double masking = 1.0 / (1.0 + beckmannLambda(view, alpha));
    return masking * beckmannDistribution(glm::normalize(sum), alpha) / (4.0 * view.z);
}

std::vector<HemispherePoint> Beckmann::quadrature(const glm::dvec3& view, double roughness,
                                                  int resolution) const {
    return ReflectionDomain(view, beckmannAlpha(roughness)).gaussRule(resolution);
}

Reflectance Beckmann::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 64;
    const glm::dvec3 view = viewDirection(cosThetaView);
    return sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
}

}  // namespace polylume::brdf
