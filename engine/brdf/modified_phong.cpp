// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/modified_phong.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brdf/hemisphere.hpp"
#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

double phongAlpha(double roughness) {
    return std::clamp(roughness * roughness, ModifiedPhong::kAlphaFloor, 1.0);
}

glm::dvec3 mirrored(const glm::dvec3& view) {
    return {-view.x, -view.y, view.z};
}

/// cos^n of the angle to the mirror direction. 1 - cos = |l - m|^2 / 2 keeps the digits that a huge
/// exponent needs.
double lobe(const glm::dvec3& view, const glm::dvec3& light, double exponent) {
    const glm::dvec3 difference = light - mirrored(view);
    const double versine = 0.5 * glm::dot(difference, difference);
    if (!(versine < 1.0)) return 0.0;
    return std::exp(exponent * std::log1p(-versine));
}

/// One angle of the domain below, measured from the lobe's middle and stretched, so that a lobe of
/// any width looks the same: angle = 2 atan(width tan(s)).
class StretchedAngle {
  public:
    explicit StretchedAngle(double alpha) : width_(0.5 * alpha) {}

    double stretched(double angle) const { return std::atan2(std::tan(0.5 * angle), width_); }

    /// The angle and its rate at a stretched one.
    QuadratureNode angle(double s) const {
        const double sine = std::sin(s);
        const double cosine = std::cos(s);
        return {2.0 * std::atan2(width_ * sine, cosine),
                2.0 * width_ / (cosine * cosine + width_ * width_ * sine * sine)};
    }

  private:
    double width_;
};

/// The upper hemisphere as l = (cos b cos g, sin b, cos b sin g), b in [0, pi/2] the latitude about
/// the y axis, doubled, and g in [0, pi] the angle from the horizon before the mirror direction.
/// The cosine to the mirror direction is cos b cos(g - g of the mirror direction), so the BRDF is a
/// product of one function of b and one of g.
std::vector<HemispherePoint> lobeRule(const glm::dvec3& view, double alpha, int resolution) {
    const double side = view.x < 0.0 ? 1.0 : -1.0;
    const double elevation = std::atan2(view.z, std::abs(view.x));
    const StretchedAngle stretch(alpha);
    // The lobe ends 90 degrees from its middle. At normal incidence that is the horizon.
    const double end = kPi - elevation > 0.5 * kPi + 1e-9 ? 0.5 * kPi : kPi - elevation;
    const std::vector<QuadratureNode> latitudes = gaussLegendre(std::max(1, resolution / 2));
    const std::vector<QuadratureNode> angles =
        spreadBetween(crowdedGaussLegendre, resolution,
                      {stretch.stretched(-elevation), stretch.stretched(end),
                       stretch.stretched(kPi - elevation)});
    const double largestLatitude = stretch.stretched(0.5 * kPi);
    std::vector<HemispherePoint> points;
    points.reserve(latitudes.size() * angles.size());
    for (const QuadratureNode& u : latitudes) {
        const QuadratureNode latitude = stretch.angle(largestLatitude * u.position);
        const double planar = std::cos(latitude.position);
        const double latitudeWeight = 2.0 * planar * latitude.weight * largestLatitude * u.weight;
        for (const QuadratureNode& v : angles) {
            const QuadratureNode angle = stretch.angle(v.position);
            const double fromHorizon = elevation + angle.position;
            // Rounding at the very edge.
            const double height = std::max(planar * std::sin(fromHorizon), 1e-12);
            points.push_back(
                {{side * planar * std::cos(fromHorizon), std::sin(latitude.position), height},
                 latitudeWeight * angle.weight * v.weight});
        }
    }
    return points;
}

}  // namespace

double phongExponent(double roughness) {
    const double alpha = phongAlpha(roughness);
    return 2.0 / (alpha * alpha) - 2.0;
}

double ModifiedPhong::evaluate(const glm::dvec3& view, const glm::dvec3& light,
                               double roughness) const {
    if (view.z <= 0.0 || light.z <= 0.0) return 0.0;
    const double exponent = phongExponent(roughness);
    return (exponent + 2.0) / (2.0 * kPi) * lobe(view, light, exponent) * light.z;
}

glm::dvec3 ModifiedPhong::sample(const glm::dvec3& view, double roughness,
                                 const glm::dvec2& random) const {
    const double exponent = phongExponent(roughness);
    // cos = x^(1 / (n + 1)); 1 - cos by expm1 for a huge n.
    const double versine = -std::expm1(std::log(1.0 - random.x) / (exponent + 1.0));
    const double sine = std::sqrt(versine * (2.0 - versine));
    const double azimuth = 2.0 * kPi * random.y;
    const glm::dvec3 axis = mirrored(view);
    const double planar = std::hypot(axis.x, axis.y);
    const glm::dvec3 tangent =
        planar > 0.0 ? glm::dvec3(-axis.y, axis.x, 0.0) / planar : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 bitangent = glm::cross(axis, tangent);
    return glm::normalize((1.0 - versine) * axis +
                          sine * (std::cos(azimuth) * tangent + std::sin(azimuth) * bitangent));
}

double ModifiedPhong::density(const glm::dvec3& view, const glm::dvec3& light,
                              double roughness) const {
    if (view.z <= 0.0) return 0.0;
    const double exponent = phongExponent(roughness);
    return (exponent + 1.0) / (2.0 * kPi) * lobe(view, light, exponent);
}

std::vector<HemispherePoint> ModifiedPhong::quadrature(const glm::dvec3& view, double roughness,
                                                       int resolution) const {
    return lobeRule(view, phongAlpha(roughness), resolution);
}

Reflectance ModifiedPhong::reflectance(double roughness, double cosThetaView) const {
    constexpr int kResolution = 64;
    const glm::dvec3 view = viewDirection(cosThetaView);
    return sumReflectance(*this, view, roughness, quadrature(view, roughness, kResolution));
}

}  // namespace polylume::brdf
