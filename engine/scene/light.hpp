// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace polylume::scene {

enum class AreaLightShape { rectangle, disk };

/// A flat Lambertian emitter (EXT_lights_area).
struct AreaLight {
    std::string name;
    AreaLightShape shape = AreaLightShape::rectangle;
    glm::vec3 center{0.0f};
    glm::mat3 worldFromLight{1.0f};  ///< Orthonormal; emits toward its -Z.
    glm::vec2 size{1.0f};            ///< Extent along local X and Y; a disk's diameter, twice.
    glm::vec3 radiance{1000.0f};     ///< Nits per channel.
    bool twoSided = false;
};

/// The corners of a rectangle, or of the one around a disk, in world space, counter-clockwise seen
/// from the emitting side.
std::vector<glm::vec3> corners(const AreaLight& light);

enum class PunctualLightType { directional, point, spot };

/// KHR_lights_punctual.
struct PunctualLight {
    std::string name;
    PunctualLightType type = PunctualLightType::point;
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< Unit; where the light goes.
    glm::vec3 intensity{1.0f};               ///< Candela per channel; lux for a directional light.
    float range = INFINITY;
    float innerConeAngle = 0.0f;          ///< From the axis.
    float outerConeAngle = 0.785398163f;  ///< From the axis, at most pi/2.
};

}  // namespace polylume::scene
