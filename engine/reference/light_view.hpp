// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

#include "reference/area_emitter.hpp"
#include "reference/reference_tracer.hpp"
#include "reference/spherical_shapes.hpp"

namespace polylume::reference {

/// A point and the axes of its shading frame: z = normal, x = view projected on the surface.
struct ShadingFrame {
    glm::dvec3 position{0.0};
    glm::dmat3 worldFromFrame{1.0};

    glm::dvec3 toFrame(const glm::dvec3& direction) const { return direction * worldFromFrame; }
    glm::dvec3 toWorld(const glm::dvec3& direction) const { return worldFromFrame * direction; }
};

/// A direction in the shading frame towards a light.
struct LightSample {
    glm::dvec3 direction{0.0};  ///< Unit.
    double distance = 0.0;      ///< To the light; 0: there is none that way.
    double density = 0.0;       ///< Of the sampling, per steradian.
};

/// A lobe of the surface's reflection, and how much of it is that lobe.
struct LobeShape {
    glm::dmat3 cosineFromLobe{1.0};  ///< M^-1, which makes it a clamped cosine.
    double chance = 1.0;             ///< Chances add up to 1.
};

/// What a point sees of one light above its surface. Distributes directions evenly over the light's
/// solid angle; for a lobe that is no cosine, over the solid angle of the light as M^-1 stretches
/// it, where the lobe is about as even as a cosine. (A density is all that the transform is taken
/// for: it makes no estimate right or wrong, but less noisy.) Where asked for, or where the solid
/// angle is too small to be computed well, evenly over the light's area.
class LightView {
  public:
    /// Keeps a reference to `emitter`. Of the `lobes` those without a chance are left out.
    LightView(const AreaEmitter& emitter, const ShadingFrame& frame,
              std::span<const LobeShape> lobes, LightSampling sampling);

    /// Nothing of the light reaches the point.
    bool isDark() const { return isDark_; }
    const glm::dvec3& radiance() const { return emitter_->radiance; }

    /// A direction from `random` in [0, 1)^2.
    LightSample sample(const glm::dvec2& random) const;

    /// How sample() would find the unit `direction`.
    LightSample find(const glm::dvec3& direction) const;

  private:
    /// The light as one lobe stretches it.
    struct Stretched {
        glm::dmat3 fromFrame{1.0}, toFrame{1.0};
        double determinant = 1.0;  ///< Of fromFrame.
        bool isIdentity = false;
        double chance = 1.0;
        double solidAngle = 0.0;
        std::optional<SphericalRectangle> rectangle;  ///< In place of triangles.
        std::vector<SphericalTriangle> triangles;

        glm::dvec3 sample(const glm::dvec2& random) const;
        double density(const glm::dvec3& direction) const;
    };

    glm::dvec3 pointAt(const glm::dvec2& planar) const {
        return origin_ + planar.x * axisX_ + planar.y * axisY_;
    }
    /// Whether all of the light is above the surface; notes where none is.
    bool isAboveSurface();
    void addStretched(const LobeShape& lobe, bool isAbove);
    glm::dvec2 samplePlane(glm::dvec2 random) const;
    double distanceTo(const glm::dvec3& direction) const;
    bool isHit(const glm::dvec3& direction, double distance) const;
    double density(const glm::dvec3& direction, double distance) const;

    const AreaEmitter* emitter_;
    glm::dvec3 origin_, axisX_, axisY_, normal_;  ///< In the shading frame.
    bool isDark_ = true;
    bool byArea_ = false;
    std::vector<Stretched> stretched_;
};

}  // namespace polylume::reference
