// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"

namespace polylume::brdf {

/// Diffuse reflection of an albedo of 1: f = 1 / pi.
class Lambert : public Brdf {
  public:
    std::string_view name() const override { return "lambert"; }
    double alphaFloor() const override { return 0.0; }
    bool hasRoughness() const override { return false; }
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override;
    /// By the cosine: every sample weighs the same.
    glm::dvec3 sample(const glm::dvec3& view, double roughness,
                      const glm::dvec2& random) const override;
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override;
};

}  // namespace polylume::brdf
