// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// Rough diffuse reflection, the qualitative model (Oren and Nayar 1994, eq. 30) with an albedo of
/// 1 and sigma = r radians, the deviation of the facets' slope angles:
///   f = (A + B max(0, cos(phi_l - phi_v)) sin(a) tan(b)) / pi, a the larger and b the smaller
///   angle to the normal, A = 1 - 0.5 s / (s + 0.33), B = 0.45 s / (s + 0.09), s = sigma^2.
/// sigma = 0 is Lambert's. Unphysical: it gains energy for small sigma at grazing views, up to
/// kLargestAlbedo, and loses it for large sigma, as the qualitative model leaves out the light that
/// bounces between facets.
class OrenNayar : public Brdf {
  public:
    /// Reached at grazing views for sigma near 0.20; rounded up.
    static constexpr double kLargestAlbedo = 1.0153;

    std::string_view name() const override { return "oren-nayar"; }
    double alphaFloor() const override { return 0.0; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// By the mean of the cosine and of the even density, so that a sample's weight stays below
    /// 4 (A + B).
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    /// Parted where f has its kinks: at the view's angle to the normal and 90 degrees from its
    /// azimuth.
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    /// The albedo in closed form, the Fresnel part within 1e-6.
    Reflectance reflectance(double roughness, double cosThetaView) const override;
};

}  // namespace polylume::brdf
