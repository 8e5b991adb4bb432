// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <vector>

namespace polylume {

/// A planar Lambertian emitter of any outline.
struct PolygonLight {
    /// World positions. The first contour is the outline, counter-clockwise seen from the emitting
    /// side; the others are holes and turn the other way. Contours are simple and do not cross.
    std::vector<std::vector<glm::vec3>> contours;
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
};

/// A flat Lambertian emitter with the outline of an ellipse or a disk.
struct EllipseLight {
    glm::vec3 center{0.0f};
    /// Half axes, at right angles; emits toward cross(halfAxisX, halfAxisY).
    glm::vec3 halfAxisX{0.5f, 0.0f, 0.0f};
    glm::vec3 halfAxisY{0.0f, 0.5f, 0.0f};
    glm::vec3 radiance{1000.0f};  ///< Nits per channel.
    bool twoSided = false;
};

enum class PunctualLightKind { directional, point, spot };

/// A light without extent, as KHR_lights_punctual has them.
struct PunctualLight {
    PunctualLightKind kind = PunctualLightKind::point;
    glm::vec3 position{0.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< Unit; where the light goes.
    glm::vec3 intensity{1.0f};               ///< Candela per channel; lux for a directional light.
    float range = INFINITY;
    float innerConeAngle = 0.0f;  ///< Radians from the axis.
    float outerConeAngle = 0.785398163f;
};

struct LightSet {
    std::vector<PolygonLight> polygons;
    std::vector<PunctualLight> punctuals;
    std::vector<EllipseLight> ellipses{};
};

/// Throws Error that names the light by its index where a value is not finite, a radiance or
/// intensity is negative or over kLargestEmission, or a contour has fewer than three vertices.
void checkLights(const LightSet& lights);

/// Twice the area of a contour, along the normal of the side from which it turns counter-clockwise.
glm::dvec3 areaVector(const std::vector<glm::vec3>& contour);

/// A regular polygon of `sides` sides stretched to the ellipse, of the ellipse's area; it turns
/// counter-clockwise seen from the emitting side.
std::vector<glm::vec3> outline(const EllipseLight& light, int sides = 64);

}  // namespace polylume
