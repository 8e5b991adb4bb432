// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// The largest relative difference of f between a pair of directions and the swapped pair, over
/// random pairs at random roughness.
double largestReciprocityError(const Brdf& brdf);

/// The integral over the whole sphere by a rule that knows nothing of any BRDF: polar coordinates
/// about `axis`, the tangent of half the polar angle spread about `width`.
double sphereIntegral(const glm::dvec3& axis, double width,
                      const std::function<double(const glm::dvec3&)>& function);

/// The axis and the width for sphereIntegral() that suit a BRDF: the mirror direction and alpha, or
/// the normal and 1.
struct LobeFrame {
    glm::dvec3 axis;
    double width;
};
LobeFrame lobeFrame(const Brdf& brdf, const glm::dvec3& view, double roughness);

/// Integrals by sphereIntegral(): of evaluate(), and of density().
double bruteForceAlbedo(const Brdf& brdf, double cosTheta, double roughness);
double densityIntegral(const Brdf& brdf, double cosTheta, double roughness);

/// Pearson's chi-square of 200000 samples against the density over cells of the sphere: how many
/// standard deviations it lies above its mean, about 0 +- 1 where they agree.
double chiSquareDeviation(const Brdf& brdf, double cosTheta, double roughness);

/// Another BRDF with factors that break each property which the functions above look at.
class SkewedBrdf : public Brdf {
  public:
    explicit SkewedBrdf(const Brdf& brdf) : brdf_(brdf) {}

    std::string_view name() const override { return "skewed"; }
    double alphaFloor() const override { return brdf_.alphaFloor(); }
    bool followsMirror() const override { return brdf_.followsMirror(); }
    bool hasRoughness() const override { return brdf_.hasRoughness(); }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override {
        return brdf_.evaluate(view, light, roughness) * (1.0 + 0.1 * view.z);
    }
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override {
        return brdf_.sample(view, roughness, random);
    }
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override {
        return brdf_.density(view, light, roughness) * (1.05 - 0.2 * light.x);
    }

  private:
    const Brdf& brdf_;
};

}  // namespace polylume::brdf
