// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "reference/shading_frame.hpp"
#include "reference/solid_emitter.hpp"
#include "reference/stretched_view.hpp"

namespace polylume::reference {

/// A ball or a capsule in a point's shading frame. From outside it is a convex cone of directions,
/// the hull of the round cones of its two ends; from inside it is everywhere.
class SolidView {
  public:
    SolidView(const SolidEmitter& emitter, const ShadingFrame& frame);

    /// Nothing of the light reaches the point.
    bool isDark() const { return isDark_; }

    /// Adds what is above the surface, and a little around it.
    void addTo(StretchedView& view) const;

    /// Directions of addTo() may miss the light.
    static bool isCoveredWidely() { return true; }

    /// To the light; 0 where it is not met.
    double distanceTo(const glm::dvec3& direction) const;
    static bool isHit(const glm::dvec3& /*direction*/, double distance) { return distance > 0.0; }

    /// What is sent from anywhere on it, in nits.
    const glm::dvec3& radianceAt(const glm::dvec3& /*point*/) const { return solid_.radiance; }

    /// Evenly over the light's area, of which only what is seen is found; its density for any
    /// direction that hits the light.
    LightSample sampleArea(const glm::dvec2& random) const;
    double areaDensity(const glm::dvec3& direction, double distance) const;

    /// Evenly over the solid angle of a cap or band of directions around the light, whatever the
    /// lobe: what serves where that is small.
    LightSample sampleSmall(const glm::dvec2& random) const;
    double smallDensity(const glm::dvec3& direction, double distance) const;

  private:
    /// One round end as it is seen: a cone around `direction`.
    struct End {
        glm::dvec3 direction{0.0, 0.0, 1.0};  ///< Unit.
        double distance = 0.0;
        double sine = 0.0, cosine = 1.0;  ///< Of the cone's half angle.
    };
    /// What only a capsule that looks longer than its near end has.
    struct Body {
        glm::dvec3 along{0.0}, across{0.0}, normal{0.0};  ///< Unit, at right angles.
        double offset = 0.0;             ///< Of the axis' line from the point, across it.
        double first = 0.0, last = 0.0;  ///< Of the axis, along it, from the point.
        double tangent = 0.0;            ///< Length of the tangents to the cylinder, across it.
    };

    End endAt(const glm::dvec3& center) const;
    /// Appends `count` directions around the part of an end's cone that is within `halfTurn` of
    /// outwards, where the unit `inward` is at right angles to the end.
    static void addEnd(std::vector<glm::dvec3>& outline, const End& end, const glm::dvec3& inward,
                       int count, double halfTurn);
    /// A convex polygon of directions around the light.
    std::vector<glm::dvec3> outline() const;
    /// A band around a capsule.
    SphericalBand makeBand() const;

    SolidEmitter solid_;       ///< In the shading frame.
    glm::dvec3 nearest_{0.0};  ///< Of the axis.
    bool isInside_ = false;    ///< The point is inside.
    bool isAbove_ = true;      ///< All of the light is above the surface.
    bool isDark_ = true;
    End near_;  ///< Where there is no body, the end that hides the rest.
    std::optional<Body> body_;
    std::variant<SphericalCap, SphericalBand> around_;
};

}  // namespace polylume::reference
