// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <string>
#include <variant>

#include "polylume/light.hpp"

namespace polylume::scene {

/// A Lambertian emitter of any shape, in world space (EXT_lights_area, POLYLUME_lights_area, or an
/// emissive mesh).
struct AreaLight {
    std::string name;
    std::variant<PolygonLight, EllipseLight, SphereLight, TubeLight> shape;
    std::string place;  ///< Where in which file it is from, for messages; may be empty.
};

/// Where a flat light is: the centre, and axes that are orthonormal. It emits toward -Z.
struct LightFrame {
    glm::vec3 center{0.0f};
    glm::mat3 worldFromLight{1.0f};
};

/// A rectangle of `size` along the frame's X and Y.
PolygonLight makeRectangle(const LightFrame& frame, const glm::vec2& size,
                           const glm::vec3& radiance);

/// An ellipse of full extents `size` along the frame's X and Y.
EllipseLight makeEllipse(const LightFrame& frame, const glm::vec2& size, const glm::vec3& radiance);

/// A tube of `length` between the centres of its caps, along the frame's X.
TubeLight makeTube(const LightFrame& frame, float length, float radius, const glm::vec3& radiance);

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
