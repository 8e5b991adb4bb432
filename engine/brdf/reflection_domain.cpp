// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/reflection_domain.hpp"

#include <algorithm>
#include <cmath>

#include "brdf/quadrature.hpp"

namespace polylume::brdf {

ReflectionDomain::ReflectionDomain(const glm::dvec3& view, double alpha)
    : view_(view), alpha_(alpha) {
    const double sine = alpha * view.x;
    const double cosine = 0.5 * view.z * (1.0 + alpha * alpha);
    amplitude_ = std::hypot(sine, cosine);
    phase_ = std::atan2(sine, cosine);
    level_ = 0.5 * view.z * (1.0 - alpha * alpha);
    maxLatitude_ = std::atan(std::sqrt((amplitude_ + level_) / view.z) / alpha);
}

HemispherePoint ReflectionDomain::point(double u, double v) const {
    // The interval of p shrinks as a square root at the end of b: b is quadratic in u there.
    const double latitude = maxLatitude_ * u * (2.0 - u);
    const double latitudeRate = 2.0 * maxLatitude_ * (1.0 - u);
    const double tangent = alpha_ * std::tan(latitude);
    const double level = level_ - view_.z * tangent * tangent;
    const double halfWidth = 0.5 * std::acos(std::clamp(-level / amplitude_, -1.0, 1.0));
    const double angle = 0.5 * phase_ + halfWidth * (2.0 * v - 1.0);
    const double cosLatitude = std::cos(latitude);
    const glm::dvec3 stretched(alpha_ * cosLatitude * std::sin(angle), alpha_ * std::sin(latitude),
                               cosLatitude * std::cos(angle));
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

std::vector<HemispherePoint> ReflectionDomain::gaussRule(int resolution) const {
    // Half a turn of latitude needs half as many nodes.
    const std::vector<QuadratureNode> us = gaussLegendre(std::max(1, resolution / 2));
    // Both ends of v lie on the horizon, where grazing views see masking change fast.
    const std::vector<QuadratureNode> vs = crowdedGaussLegendre(resolution);
    std::vector<HemispherePoint> points;
    points.reserve(us.size() * vs.size());
    for (const QuadratureNode& u : us) {
        for (const QuadratureNode& v : vs) {
            HemispherePoint node = point(u.position, v.position);
            node.solidAngle *= u.weight * v.weight;
            points.push_back(node);
        }
    }
    return points;
}

}  // namespace polylume::brdf
