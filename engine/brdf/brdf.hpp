// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

namespace polylume::brdf {

/// One point of a rule that integrates over the upper hemisphere.
struct HemispherePoint {
    glm::dvec3 direction;  ///< Unit, z > 0.
    double solidAngle;     ///< Its weight in steradians.
};

/// evaluate() and density() for one pair of directions.
struct Scattering {
    double value = 0.0;
    double density = 0.0;
};

/// What a table stores of a BRDF besides the shape of its lobe.
struct Reflectance {
    double albedo = 0.0;   ///< Integral of f cos over the upper hemisphere with Fresnel = 1.
    double fresnel = 0.0;  ///< The same, weighted by (1 - v.h)^5.
};

/// An isotropic BRDF over perceptual roughness r in [0, 1], with a Fresnel term of 1, in the
/// shading frame (z = normal). All directions are unit and point away from the surface. To add one,
/// derive from this class and implement the five pure functions; the rest works through them.
class Brdf {
  public:
    Brdf() = default;
    Brdf(const Brdf&) = delete;
    Brdf& operator=(const Brdf&) = delete;
    virtual ~Brdf() = default;

    /// What tables and the command call it: lower case, no spaces.
    virtual std::string_view name() const = 0;

    /// The least alpha that is used, however small the roughness; 0 for a BRDF without an alpha.
    virtual double alphaFloor() const = 0;

    /// Whether narrow lobes follow the mirror direction. A table of such a BRDF stores its lobes
    /// relative to that direction, any other relative to halfway between it and the normal.
    virtual bool followsMirror() const { return false; }

    /// Whether it changes with the roughness. One that does not gives a table of a single column.
    virtual bool hasRoughness() const { return true; }

    /// Whether albedoColor() has a colour of its own.
    virtual bool hasColor() const { return false; }

    /// f(view, light) * cos(theta_light), per steradian; 0 where either is not above the surface.
    virtual double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                            double roughness) const = 0;

    /// A light direction for `view` (z > 0), from `random` in [0, 1)^2. It may lie below the
    /// surface, where it carries nothing. Continuous in `random` almost everywhere.
    virtual glm::dvec3 sample(const glm::dvec3& view, double roughness,
                              const glm::dvec2& random) const = 0;

    /// The density of sample() per steradian. Its integral over the whole sphere is 1.
    virtual double density(const glm::dvec3& view, const glm::dvec3& light,
                           double roughness) const = 0;

    /// evaluate() and density() together, which may cost less than both.
    virtual Scattering scatter(const glm::dvec3& view, const glm::dvec3& light,
                               double roughness) const {
        return {evaluate(view, light, roughness), density(view, light, roughness)};
    }

    /// A rule of about `resolution` x `resolution` points that covers the upper hemisphere, densely
    /// where the lobe is high, and is symmetric in y for the view direction in the xz plane (z >
    /// 0). Points of negative y are left out and those of positive y weigh double. The default lays
    /// a grid over sample().
    virtual std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                                    int resolution) const;

    /// Albedo and Fresnel-weighted albedo for a view at `cosThetaView` in (0, 1], by a
    /// deterministic rule. The default sums a fine quadrature().
    virtual Reflectance reflectance(double roughness, double cosThetaView) const;

    /// The albedo of linear Rec. 709 red, green and blue; evaluate() and reflectance() are then of
    /// their luminance. The default is grey.
    virtual glm::dvec3 albedoColor(double roughness, double cosThetaView) const;
};

/// The view direction in the xz plane at `cosThetaView`, clamped to [kMinCosThetaView, 1].
glm::dvec3 viewDirection(double cosThetaView);

/// Views closer to the surface's plane count as this.
inline constexpr double kMinCosThetaView = 1e-4;

/// (1 - v.h)^5 with h the half vector of `view` and `light` (Schlick 1994, eq. 15).
double fresnelWeight(const glm::dvec3& view, const glm::dvec3& light);

}  // namespace polylume::brdf
