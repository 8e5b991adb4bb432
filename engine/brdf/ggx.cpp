// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/ggx.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/quadrature.hpp"
#include "brdf/reflection_domain.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

double ggxAlpha(double roughness) {
    return std::clamp(roughness * roughness, Ggx::kAlphaFloor, 1.0);
}

double ggxDistribution(const glm::dvec3& halfVector, double alpha) {
    if (halfVector.z <= 0.0) return 0.0;
    // alpha^2 / (pi (x^2 + y^2 + alpha^2 z^2)^2) for a unit vector: no cancellation for small
    // alpha.
    const double planar = halfVector.x * halfVector.x + halfVector.y * halfVector.y;
    const double stretched = planar + alpha * alpha * halfVector.z * halfVector.z;
    return alpha * alpha / (kPi * stretched * stretched);
}

double ggxLambda(const glm::dvec3& direction, double alpha) {
    const double planar = direction.x * direction.x + direction.y * direction.y;
    const double slope = alpha * alpha * planar / (direction.z * direction.z);
    // (sqrt(1 + s) - 1) / 2 without its cancellation.
    return 0.5 * slope / (1.0 + std::sqrt(1.0 + slope));
}

double Ggx::evaluate(const glm::dvec3& view, const glm::dvec3& light, double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const double alpha = ggxAlpha(roughness);
    const double masking = 1.0 / (1.0 + ggxLambda(view, alpha) + ggxLambda(light, alpha));
    return ggxDistribution(glm::normalize(view + light), alpha) * masking / (4.0 * view.z);
}

glm::dvec3 Ggx::sample(const glm::dvec3& view, double roughness, const glm::dvec2& random) const {
    const double alpha = ggxAlpha(roughness);
    // Dupuy and Benyoub 2023: half of what leaves a mirroring hemisphere toward the stretched view
    // is a cap of the sphere, sampled evenly.
    const glm::dvec3 stretched(alpha * view.x, alpha * view.y, view.z);
    const glm::dvec3 stretchedView = stretched / std::sqrt(glm::dot(stretched, stretched));
    const double height = (1.0 - random.x) * (1.0 + stretchedView.z) - stretchedView.z;
    const double radius = std::sqrt(std::clamp(1.0 - height * height, 0.0, 1.0));
    const double azimuth = 2.0 * kPi * random.y;
    const glm::dvec3 normal =
        glm::dvec3(radius * std::cos(azimuth), radius * std::sin(azimuth), height) + stretchedView;
    const glm::dvec3 unstretched(alpha * normal.x, alpha * normal.y, normal.z);
    const glm::dvec3 half = unstretched / std::sqrt(glm::dot(unstretched, unstretched));
    return 2.0 * glm::dot(view, half) * half - view;
}

double Ggx::density(const glm::dvec3& view, const glm::dvec3& light, double roughness) const {
    if (view.z <= 0.0) return 0.0;
    const double alpha = ggxAlpha(roughness);
    const glm::dvec3 sum = view + light;
    if (sum.z <= 0.0) return 0.0;
    // Visible normals D_v(h) = G1 (v.h) D / v.z, over the 4 (v.h) of the reflection.
    const double masking = 1.0 / (1.0 + ggxLambda(view, alpha));
    return masking * ggxDistribution(glm::normalize(sum), alpha) / (4.0 * view.z);
}

Scattering Ggx::scatter(const glm::dvec3& view, const glm::dvec3& light, double roughness) const {
    const glm::dvec3 sum = view + light;
    if (view.z <= 0.0 || sum.z <= 0.0) return {};
    const double alpha = ggxAlpha(roughness);
    // What evaluate() and density() have in common.
    const double reflection =
        ggxDistribution(sum / std::sqrt(glm::dot(sum, sum)), alpha) / (4.0 * view.z);
    const double masked = 1.0 + ggxLambda(view, alpha);
    const double value = light.z > 0.0 ? reflection / (masked + ggxLambda(light, alpha)) : 0.0;
    return {value, reflection / masked};
}

std::vector<HemispherePoint> Ggx::quadrature(const glm::dvec3& view, double roughness,
                                             int resolution) const {
    return ReflectionDomain(view, ggxAlpha(roughness)).gaussRule(resolution);
}

Reflectance Ggx::reflectance(double roughness, double cosThetaView) const {
    constexpr int kNodeCount = 48;
    static const std::vector<QuadratureNode> rule = tanhSinh(kNodeCount);
    const glm::dvec3 view = viewDirection(cosThetaView);
    const ReflectionDomain domain(view, ggxAlpha(roughness));
    Reflectance sum;
    for (const QuadratureNode& u : rule) {
        for (const QuadratureNode& v : rule) {
            const HemispherePoint point = domain.point(u.position, v.position);
            const double value =
                evaluate(view, point.direction, roughness) * point.solidAngle * u.weight * v.weight;
            sum.albedo += value;
            sum.fresnel += value * fresnelWeight(view, point.direction);
        }
    }
    return sum;
}

}  // namespace polylume::brdf
