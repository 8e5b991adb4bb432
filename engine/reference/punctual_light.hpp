// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "polylume/light.hpp"

namespace polylume::reference {

/// The light that a point gets of a light without extent.
struct PunctualIlluminance {
    glm::dvec3 illuminance{0.0};  ///< Lux on a surface that faces the light.
    glm::dvec3 toLight{0.0};      ///< Unit.
    double distance = 0.0;        ///< Infinite for a directional light.
};

/// As KHR_lights_punctual has it.
PunctualIlluminance illuminanceOf(const PunctualLight& light, const glm::dvec3& position);

}  // namespace polylume::reference
