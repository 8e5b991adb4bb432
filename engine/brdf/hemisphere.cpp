// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/hemisphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

glm::dvec3 directionAtHeight(double z, double turn) {
    const double planar = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
    const double azimuth = 2.0 * kPi * turn;
    return {planar * std::cos(azimuth), planar * std::sin(azimuth), z};
}

glm::dvec3 sampleCosine(const glm::dvec2& random) {
    return directionAtHeight(std::sqrt(1.0 - random.x), random.y);
}

double cosineDensity(const glm::dvec3& light) {
    return std::max(light.z, 0.0) / kPi;
}

glm::dvec3 sampleCosineOrEven(const glm::dvec2& random) {
    // The share below z is (z + z^2) / 2.
    const double below = 1.0 - random.x;
    return directionAtHeight(4.0 * below / (1.0 + std::sqrt(1.0 + 8.0 * below)), random.y);
}

double cosineOrEvenDensity(const glm::dvec3& light) {
    return light.z > 0.0 ? (0.5 + light.z) / (2.0 * kPi) : 0.0;
}

std::vector<HemispherePoint> polarRule(const std::vector<QuadratureNode>& thetas,
                                       const std::vector<QuadratureNode>& azimuths) {
    std::vector<HemispherePoint> points;
    points.reserve(thetas.size() * azimuths.size());
    for (const QuadratureNode& theta : thetas) {
        const double sine = std::sin(theta.position);
        const double cosine = std::max(std::cos(theta.position), 1e-12);
        for (const QuadratureNode& azimuth : azimuths) {
            points.push_back(
                {{sine * std::cos(azimuth.position), sine * std::sin(azimuth.position), cosine},
                 2.0 * sine * theta.weight * azimuth.weight});
        }
    }
    return points;
}

Reflectance sumReflectance(const Brdf& brdf, const glm::dvec3& view, double roughness,
                           const std::vector<HemispherePoint>& points) {
    Reflectance sum;
    for (const HemispherePoint& point : points) {
        const double value = brdf.evaluate(view, point.direction, roughness) * point.solidAngle;
        sum.albedo += value;
        sum.fresnel += value * fresnelWeight(view, point.direction);
    }
    return sum;
}

}  // namespace polylume::brdf
