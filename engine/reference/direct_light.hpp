// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "polylume/light.hpp"
#include "reference/area_emitter.hpp"
#include "reference/ray_scene.hpp"
#include "reference/shaded_point.hpp"

namespace polylume::reference {

/// The lights of a scene, and whether surfaces block them.
struct Lighting {
    std::vector<AreaEmitter> emitters;
    std::vector<PunctualLight> punctuals;
    const RayScene* occluders = nullptr;  ///< Null: nothing casts a shadow.
    LightSampling sampling = LightSampling::solidAngle;
};

/// Estimates what one point reflects of the lights. Two estimators for every area light, one that
/// samples the light and one that samples the BRDF, are weighted by the balance heuristic (Veach
/// and Guibas 1995). No light hides another.
class DirectLight {
  public:
    /// Keeps references to all; `surface` is what `point` was made of.
    DirectLight(const Surface& surface, const ShadedPoint& point, const Lighting& lighting);

    /// Whether any area light can reach the point.
    bool hasAreaLight() const { return !views_.empty(); }
    std::size_t areaLightCount() const { return views_.size(); }

    /// Of area light `index` out of areaLightCount(), by a sample of the light.
    glm::dvec3 byLight(std::size_t index, const glm::dvec2& random) const;

    /// Of all area lights, by one direction that `point` sampled, with the reflection there.
    glm::dvec3 byReflection(const glm::dvec3& direction, const Reflected& reflected) const;

  private:
    const Surface& surface_;
    const ShadedPoint& point_;
    const Lighting& lighting_;
    std::vector<LightView> views_;
};

/// What one point reflects of the lights without extent: no estimate.
glm::dvec3 punctualLight(const Surface& surface, const ShadedPoint& point,
                         const Lighting& lighting);

/// A ray that leaves the surface at `position` to the side that `directionWorld` points to.
Ray rayFrom(const glm::dvec3& position, const glm::dvec3& geometricNormal,
            const glm::dvec3& directionWorld, const RayScene& scene);

}  // namespace polylume::reference
