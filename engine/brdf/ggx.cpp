// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/ggx.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

/// The half vectors that reflect one view direction to above the surface, as a region that can be
/// integrated over exactly. Stretching h by 1/alpha makes the distribution of normals uniform; the
/// stretched normal N = (cos b sin p, sin b, cos b cos p) is measured by its latitude b about the y
/// axis and by its angle p in the plane of view. For one b, light.z >= 0 is then an interval of p:
///   light.z ~ 2 (v.q) q.z - v.z |q|^2 with q = (alpha N.x, alpha N.y, N.z)
///           = cos^2 b (R cos(2 p - delta) + K(b)).
class ReflectionDomain {
  public:
    ReflectionDomain(const glm::dvec3& view, double alpha) : view_(view), alpha_(alpha) {
        const double sine = alpha * view.x;
        const double cosine = 0.5 * view.z * (1.0 + alpha * alpha);
        amplitude_ = std::hypot(sine, cosine);
        phase_ = std::atan2(sine, cosine);
        level_ = 0.5 * view.z * (1.0 - alpha * alpha);
        maxLatitude_ = std::atan(std::sqrt((amplitude_ + level_) / view.z) / alpha);
    }

    /// The point at (u, v) in [0, 1]^2; the weight is steradians per unit of u and v, both signs of
    /// y.
    HemispherePoint point(double u, double v) const {
        // The interval of p shrinks as a square root at the end of b: b is quadratic in u there.
        const double latitude = maxLatitude_ * u * (2.0 - u);
        const double latitudeRate = 2.0 * maxLatitude_ * (1.0 - u);
        const double tangent = alpha_ * std::tan(latitude);
        const double level = level_ - view_.z * tangent * tangent;
        const double halfWidth = 0.5 * std::acos(std::clamp(-level / amplitude_, -1.0, 1.0));
        const double angle = 0.5 * phase_ + halfWidth * (2.0 * v - 1.0);
        const double cosLatitude = std::cos(latitude);
        const glm::dvec3 stretched(alpha_ * cosLatitude * std::sin(angle),
                                   alpha_ * std::sin(latitude), cosLatitude * std::cos(angle));
        const double length = glm::length(stretched);
        const glm::dvec3 half = stretched / length;
        const double viewDotHalf = glm::dot(view_, half);
        glm::dvec3 light = 2.0 * viewDotHalf * half - view_;
        light.z = std::max(light.z, 1e-12);  // Rounding at the very edge.
        // d light = 4 (v.h) d h; d h = alpha^2 / |q|^3 d N; d N = cos b d b d p.
        const double halfRate = alpha_ * alpha_ / (length * length * length);
        const double area = cosLatitude * latitudeRate * 2.0 * halfWidth;
        return {light, 2.0 * 4.0 * std::max(viewDotHalf, 0.0) * halfRate * area};
    }

  private:
    glm::dvec3 view_;
    double alpha_;
    double amplitude_;  // R
    double phase_;      // delta
    double level_;      // K(0)
    double maxLatitude_;
};

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
    const ReflectionDomain domain(view, ggxAlpha(roughness));
    // Half a turn of latitude needs half as many nodes.
    const std::vector<QuadratureNode> us = gaussLegendre(std::max(1, resolution / 2));
    const std::vector<QuadratureNode> vs = gaussLegendre(resolution);
    std::vector<HemispherePoint> points;
    points.reserve(us.size() * vs.size());
    for (const QuadratureNode& u : us) {
        for (const QuadratureNode& v : vs) {
            HemispherePoint point = domain.point(u.position, v.position);
            point.solidAngle *= u.weight * v.weight;
            points.push_back(point);
        }
    }
    return points;
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
