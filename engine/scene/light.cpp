// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light.hpp"

namespace polylume::scene {

PolygonLight makeRectangle(const LightFrame& frame, const glm::vec2& size,
                           const glm::vec3& radiance) {
    // Clockwise around +Z is counter-clockwise seen from the emitting side, -Z.
    PolygonLight light;
    light.radiance = radiance;
    std::vector<glm::vec3>& contour = light.contours.emplace_back();
    for (const glm::vec2& corner :
         {glm::vec2(-0.5f, -0.5f), {-0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}}) {
        contour.push_back(frame.center + frame.worldFromLight * glm::vec3(corner * size, 0.0f));
    }
    return light;
}

EllipseLight makeEllipse(const LightFrame& frame, const glm::vec2& size,
                         const glm::vec3& radiance) {
    // Turned so that the cross product of the half axes is the frame's -Z.
    return {frame.center, 0.5f * size.x * frame.worldFromLight[0],
            -0.5f * size.y * frame.worldFromLight[1], radiance};
}

TubeLight makeTube(const LightFrame& frame, float length, float radius, const glm::vec3& radiance) {
    const glm::vec3 half = 0.5f * length * frame.worldFromLight[0];
    return {frame.center - half, frame.center + half, radius, radiance};
}

}  // namespace polylume::scene
