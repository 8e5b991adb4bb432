// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "reference/flat_emitter.hpp"
#include "reference/shading_frame.hpp"
#include "reference/stretched_view.hpp"

namespace polylume::reference {

/// A flat light in a point's shading frame.
class FlatView {
  public:
    /// Keeps a reference to `emitter`.
    FlatView(const FlatEmitter& emitter, const ShadingFrame& frame);

    /// Nothing of the light reaches the point.
    bool isDark() const { return isDark_; }

    /// Adds what is above the surface.
    void addTo(StretchedView& view) const;

    /// Directions of addTo() may miss the light.
    bool isCoveredWidely() const { return emitter_->isCoveredWidely; }

    /// To the light's plane; no positive and finite number where that is not met.
    double distanceTo(const glm::dvec3& direction) const {
        return glm::dot(origin_, normal_) / glm::dot(direction, normal_);
    }
    /// Whether the light is at the `distance` that distanceTo() gives.
    bool isHit(const glm::dvec3& direction, double distance) const {
        if (!(distance > 0.0) || !std::isfinite(distance)) return false;
        return emitter_->contains(planarOf(distance * direction));
    }

    /// What is sent from there, in nits.
    glm::dvec3 radianceAt(const glm::dvec3& point) const {
        return emitter_->texture ? emitter_->radianceAt(planarOf(point)) : emitter_->radiance;
    }

    /// Evenly over the light's area; its density for any direction that hits the light.
    LightSample sampleArea(const glm::dvec2& random) const;
    double areaDensity(const glm::dvec3& direction, double distance) const;

    /// What serves where the solid angle is too small to be computed well.
    LightSample sampleSmall(const glm::dvec2& random) const { return sampleArea(random); }
    double smallDensity(const glm::dvec3& direction, double distance) const {
        return areaDensity(direction, distance);
    }

  private:
    glm::dvec2 planarOf(const glm::dvec3& point) const {
        return planarCoordinates(point - origin_, axisX_, axisY_);
    }
    glm::dvec3 pointAt(const glm::dvec2& planar) const {
        return origin_ + planar.x * axisX_ + planar.y * axisY_;
    }
    glm::dvec2 samplePlane(glm::dvec2 random) const;

    const FlatEmitter* emitter_;
    glm::dvec3 origin_{0.0}, axisX_{0.0}, axisY_{0.0}, normal_{0.0};  ///< In the shading frame.
    bool isAbove_ = true;  ///< All of the light is above the surface.
    bool isDark_ = true;
};

}  // namespace polylume::reference
