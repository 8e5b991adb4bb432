// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// Isotropic Beckmann (Beckmann and Spizzichino 1963, as Walter et al. 2007, eq. 25 has it) with
/// height-correlated Smith masking and shadowing (Heitz 2014, eq. 99) by the exact Lambda, sampled
/// by visible normals (Heitz and d'Eon 2014). alpha = r^2, at least kAlphaFloor. Like any model of
/// single scattering it loses the light that would bounce twice, up to a half at r = 1.
class Beckmann : public Brdf {
  public:
    static constexpr double kAlphaFloor = 1e-4;

    std::string_view name() const override { return "beckmann"; }
    double alphaFloor() const override { return kAlphaFloor; }
    bool followsMirror() const override { return true; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
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

/// alpha of a perceptual roughness in [0, 1].
double beckmannAlpha(double roughness);

/// The distribution of normals D(h) = exp(-tan^2 / alpha^2) / (pi alpha^2 cos^4) per steradian.
double beckmannDistribution(const glm::dvec3& halfVector, double alpha);

/// Smith's Lambda of a direction with z > 0 (Heitz 2014, eq. 68):
/// (exp(-a^2) / (a sqrt(pi)) - erfc(a)) / 2 with a = 1 / (alpha tan(theta)).
double beckmannLambda(const glm::dvec3& direction, double alpha);

}  // namespace polylume::brdf
