// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/brdf.hpp"

#include <algorithm>
#include <cmath>

#include "brdf/hemisphere.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {

std::vector<HemispherePoint> Brdf::quadrature(const glm::dvec3& view, double roughness,
                                              int resolution) const {
    // Nodes that crowd at the ends: rare directions, far from the lobe's middle, often lie there.
    const std::vector<QuadratureNode> rule = gaussLegendre(resolution);
    std::vector<HemispherePoint> points;
    points.reserve(rule.size() * rule.size());
    for (const QuadratureNode& u : rule) {
        for (const QuadratureNode& v : rule) {
            const glm::dvec3 light = sample(view, roughness, {u.position, v.position});
            const double lightDensity = density(view, light, roughness);
            if (light.z <= 0.0 || !(lightDensity > 0.0)) continue;
            // Folded to y >= 0, where the mirrored point lies too.
            points.push_back(
                {{light.x, std::abs(light.y), light.z}, u.weight * v.weight / lightDensity});
        }
    }
    return points;
}

Reflectance Brdf::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 256;
    const glm::dvec3 view = viewDirection(cosThetaView);
    return sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
}

glm::dvec3 Brdf::albedoColor(double roughness, double cosThetaView) const {
    return glm::dvec3(reflectance(roughness, cosThetaView).albedo);
}

glm::dvec3 viewDirection(double cosThetaView) {
    const double cosTheta = std::clamp(cosThetaView, kMinCosThetaView, 1.0);
    return {std::sqrt((1.0 - cosTheta) * (1.0 + cosTheta)), 0.0, cosTheta};
}

double fresnelWeight(const glm::dvec3& view, const glm::dvec3& light) {
    // |v + l| = 2 v.h for unit vectors.
    const double cosHalf = std::min(0.5 * glm::length(view + light), 1.0);
    const double base = 1.0 - cosHalf;
    const double square = base * base;
    return square * square * base;
}

}  // namespace polylume::brdf
