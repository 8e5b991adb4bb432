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
    // Heitz 2018: a point of the hemisphere's outline as seen from the stretched view direction.
    const glm::dvec3 stretchedView =
        glm::normalize(glm::dvec3(alpha * view.x, alpha * view.y, view.z));
    const double planar = std::hypot(stretchedView.x, stretchedView.y);
    const glm::dvec3 tangent = planar > 0.0
                                   ? glm::dvec3(-stretchedView.y, stretchedView.x, 0.0) / planar
                                   : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 bitangent = glm::cross(stretchedView, tangent);
    const double radius = std::sqrt(random.x);
    const double azimuth = 2.0 * kPi * random.y;
    const double x = radius * std::cos(azimuth);
    const double blend = 0.5 * (1.0 + stretchedView.z);
    const double y = (1.0 - blend) * std::sqrt(1.0 - x * x) + blend * radius * std::sin(azimuth);
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    const glm::dvec3 normal = x * tangent + y * bitangent + z * stretchedView;
    const glm::dvec3 half =
        glm::normalize(glm::dvec3(alpha * normal.x, alpha * normal.y, std::max(0.0, normal.z)));
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
