// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// Burley's diffuse reflection (Burley 2012, section 5.3) with a base colour of 1 and his roughness
/// = the perceptual r:
///   f = (1 + (F - 1) (1 - l.z)^5) (1 + (F - 1) (1 - v.z)^5) / pi, F = 0.5 + 2 r cos^2(theta_d),
/// theta_d the angle between the light and the half vector. An empirical fit: smooth surfaces
/// darken toward grazing views, to 0.49, and rough ones gain energy there, up to kLargestAlbedo.
class BurleyDiffuse : public Brdf {
  public:
    /// Reached at r = 1 for grazing views; rounded up.
    static constexpr double kLargestAlbedo = 1.5575;

    std::string_view name() const override { return "burley"; }
    double alphaFloor() const override { return 0.0; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// By the cosine.
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    /// Within 1e-6 for every roughness and view; the albedo within rounding.
    Reflectance reflectance(double roughness, double cosThetaView) const override;
};

}  // namespace polylume::brdf
