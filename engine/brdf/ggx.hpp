// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// Isotropic GGX (Walter et al. 2007) with height-correlated Smith masking and shadowing (Heitz
/// 2014), sampled by visible normals (Heitz 2018, by the caps of
/// Dupuy and Benyoub 2023). alpha = r^2, at least kAlphaFloor, which is
/// below the second column of a 64x64 table and keeps its matrices well within the range of
/// float32.
class Ggx : public Brdf {
  public:
    static constexpr double kAlphaFloor = 1e-4;

    std::string_view name() const override { return "ggx"; }
    double alphaFloor() const override { return kAlphaFloor; }
    bool followsMirror() const override { return true; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    Scattering scatter(const glm::dvec3& view, const glm::dvec3& light,
                       double roughness) const override;
    /// Covers the upper hemisphere exactly, with no point below it.
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    /// Within 1e-6 for every roughness and view (measured against twice the resolution).
    Reflectance reflectance(double roughness, double cosThetaView) const override;
};

/// alpha of a perceptual roughness in [0, 1].
double ggxAlpha(double roughness);

/// The distribution of normals D(h) per steradian, h.z > 0 (Walter et al. 2007, eq. 33).
double ggxDistribution(const glm::dvec3& halfVector, double alpha);

/// Smith's Lambda of a direction with z > 0 (Heitz 2014, eq. 72): G1 = 1 / (1 + Lambda), and the
/// height-correlated G2 = 1 / (1 + Lambda(v) + Lambda(l)) (eq. 99).
double ggxLambda(const glm::dvec3& direction, double alpha);

}  // namespace polylume::brdf
