// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// The "Charlie" sheen of cloth (Estevez and Kulla 2017) as glTF's KHR_materials_sheen evaluates
/// it, with a sheen colour of 1 and no Fresnel term:
///   f = D(h) / (4 v.z l.z (1 + Lambda(v.z) + Lambda(l.z)))
///   D(h) = (2 + 1/alpha) sin(theta_h)^(1/alpha) / (2 pi)
///   Lambda(c) = exp(L(c)) for c < 0.5, else exp(2 L(0.5) - L(1 - c))
///   L(x) = a / (1 + b x^c) + d x + e, with t = (1 - alpha)^2 and
///     a = 21.5473  + t (25.3245  - 21.5473)
///     b = 3.82987  + t (3.32435  - 3.82987)
///     c = 0.19823  + t (0.16801  - 0.19823)
///     d = -1.97760 + t (-1.27393 + 1.97760)
///     e = -4.32054 + t (-4.85967 + 4.32054)
/// alpha = r^2 of the sheen's own roughness, at least kAlphaFloor: below it the model would reflect
/// more than arrives at grazing views (up to 2.13 times at alpha = 0.01), and all but nothing
/// elsewhere. The paper's softening of the terminator is left out, as in the extension; so is the
/// clamp of the masking to [0, 1] that some renderers add. Lambda is a fit, not Smith's integral of
/// this D. Reciprocal.
class CharlieSheen : public Brdf {
  public:
    static constexpr double kAlphaFloor = 0.07;

    std::string_view name() const override { return "charlie"; }
    double alphaFloor() const override { return kAlphaFloor; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// By heights, half of them even, half crowding at the horizon.
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override;
    /// Within 1e-6 for every roughness and view.
    Reflectance reflectance(double roughness, double cosThetaView) const override;
};

/// alpha of a perceptual roughness in [0, 1].
double charlieAlpha(double roughness);

/// D(h) above.
double charlieDistribution(const glm::dvec3& halfVector, double alpha);

/// Lambda(c) above.
double charlieLambda(double cosTheta, double alpha);

}  // namespace polylume::brdf
