// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "polylume/light.hpp"

namespace polylume::reference {

/// Where a line from a point meets a convex solid, in units of its direction; negative behind it.
struct Chord {
    double enter = 0.0, leave = 0.0;
};

/// All points within `radius` of the line from start to start + axis, as a light: a capsule, or
/// where the axis has no length a ball.
struct SolidEmitter {
    glm::dvec3 start{0.0};
    glm::dvec3 axis{0.0};
    double radius = 0.0;
    glm::dvec3 radiance{0.0};  ///< Nits.
    bool twoSided = false;     ///< Emits inwards, too.

    /// Of its surface.
    double area() const;

    /// The point of the axis that is nearest to the origin.
    glm::dvec3 nearestOfAxis() const;

    /// Where the line through the origin along the unit `direction` is in the solid.
    std::optional<Chord> chord(const glm::dvec3& direction) const;

    /// Unit, outwards, at a point of the surface.
    glm::dvec3 normalAt(const glm::dvec3& point) const;
};

SolidEmitter solidEmitter(const SphereLight& light);
SolidEmitter solidEmitter(const TubeLight& light);

}  // namespace polylume::reference
