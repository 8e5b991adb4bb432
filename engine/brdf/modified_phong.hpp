// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// The specular lobe of the modified Phong model (Lafortune and Willems 1994, eq. 5):
/// f = (n + 2) / (2 pi) cos^n(a), a the angle between the light and the mirrored view direction, 0
/// from a = 90 degrees on. n = 2 / alpha^2 - 2 with alpha = r^2, at least kAlphaFloor: the lobe is
/// about exp(-a^2 / alpha^2), as wide in the light as the half vectors of Beckmann's alpha are, so
/// half as wide as Beckmann's lobe; n = 0 at r = 1. Reciprocal, albedo 1 at normal incidence.
/// Unphysical: the lobe stays round at grazing views and loses its part below the surface, about a
/// half. At r = 1 it is even up to 90 degrees from the mirror direction and jumps to 0 there.
class ModifiedPhong : public Brdf {
  public:
    static constexpr double kAlphaFloor = 1e-4;

    std::string_view name() const override { return "phong"; }
    double alphaFloor() const override { return kAlphaFloor; }
    bool followsMirror() const override { return true; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// Of density (n + 1) / (2 pi) cos^n(a).
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    /// Covers the upper hemisphere exactly, with no point below it.
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    /// Within 1e-6 for every roughness and view.
    Reflectance reflectance(double roughness, double cosThetaView) const override;
};

/// The exponent n of a perceptual roughness in [0, 1]: 0 to 2e8.
double phongExponent(double roughness);

}  // namespace polylume::brdf
