// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/default_lighting.hpp"

#include <algorithm>
#include <cmath>

namespace polylume::scene {
namespace {

/// A light of the rig, in the camera's axes (x right, y up, z toward the viewer) and radii of the
/// bounds.
struct RigLight {
    const char* name;
    glm::vec3 position;
    glm::vec2 size;
    glm::vec3 color;
    float luminance;  ///< Nits.
};

// A square of 2 x 2 radii at 3.3 radii fills 0.35 sr: 9000 nits give 3100 lux, 1000 nits from
// white.
constexpr RigLight kRig[] = {
    {"key", {-2.1f, 1.9f, 1.7f}, {2.0f, 2.0f}, {1.0f, 0.95f, 0.88f}, 9000.0f},
    {"fill", {2.6f, 0.5f, 1.5f}, {1.6f, 2.4f}, {0.84f, 0.92f, 1.0f}, 2400.0f},
    {"rim", {0.9f, 2.5f, -2.4f}, {2.6f, 1.2f}, {1.0f, 0.98f, 0.96f}, 6500.0f}};

constexpr float kWidestAspect = 2.0f;

glm::mat3 frameToward(const glm::vec3& from, const glm::vec3& target, const glm::vec3& up) {
    const glm::vec3 z = glm::normalize(from - target);
    const glm::vec3 side = glm::cross(up, z);
    const glm::vec3 x = glm::length(side) > 1e-4f ? glm::normalize(side) : glm::vec3(1, 0, 0);
    return {x, glm::cross(z, x), z};
}

/// How far to the side of the view axis (1 at the picture's edge) the light reaches inward, from
/// the camera; above 1 it is out of the picture, behind the camera it is infinite.
float innermostReach(const PolygonLight& light, const Camera& camera) {
    const glm::mat3 axes(camera.worldFromCamera);
    const glm::vec3 eye(camera.worldFromCamera[3]);
    float leftOf = INFINITY, rightOf = INFINITY, above = INFINITY, below = INFINITY;
    for (const glm::vec3& corner : light.contours.front()) {
        const glm::vec3 offset = glm::transpose(axes) * (corner - eye);
        float halfHeight = 0.0f;
        if (const auto* perspective = std::get_if<Perspective>(&camera.projection)) {
            halfHeight = -offset.z * std::tan(0.5f * perspective->yFovRadians);
        } else {
            halfHeight = std::get<Orthographic>(camera.projection).yMag;
        }
        if (halfHeight <= 0.0f) continue;
        rightOf = std::min(rightOf, offset.x / (halfHeight * kWidestAspect));
        leftOf = std::min(leftOf, -offset.x / (halfHeight * kWidestAspect));
        above = std::min(above, offset.y / halfHeight);
        below = std::min(below, -offset.y / halfHeight);
    }
    return std::max(std::max(rightOf, leftOf), std::max(above, below));
}

}  // namespace

std::vector<AreaLight> defaultRig(const Bounds& bounds, const Camera& camera) {
    Bounds lit = bounds;
    if (lit.isEmpty()) lit = {glm::vec3(-0.5f), glm::vec3(0.5f)};
    const float radius = lit.radius() > 0.0f ? lit.radius() : 1.0f;
    const glm::mat3 cameraAxes(camera.worldFromCamera);
    std::vector<AreaLight> lights;
    for (const RigLight& source : kRig) {
        PolygonLight light;
        glm::vec3 position = source.position;
        // Moved outward, and enlarged alike so that it lights as much, until the camera can't see
        // it. A camera inside the bounds may see it whatever is done.
        for (int attempt = 0; attempt < 12; ++attempt) {
            const glm::vec3 center = lit.center() + cameraAxes * (radius * position);
            const float distance = glm::length(position) / glm::length(source.position);
            light = makeRectangle({center, frameToward(center, lit.center(), cameraAxes[1])},
                                  radius * distance * source.size, source.luminance * source.color);
            if (innermostReach(light, camera) > 1.02f) break;
            position *= glm::vec3(1.12f, 1.12f, 1.0f);
        }
        lights.push_back({source.name, light, "default lights"});
    }
    return lights;
}

}  // namespace polylume::scene
