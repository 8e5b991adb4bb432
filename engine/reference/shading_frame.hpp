// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

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

}  // namespace polylume::reference
