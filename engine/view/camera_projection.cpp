// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/camera_projection.hpp"

#include <algorithm>
#include <cmath>

namespace polylume {
namespace {

/// The picture plane at distance 1 (perspective) or anywhere (orthographic), and depth as
/// z_clip = depthScale * z_view + depthOffset.
struct Projection {
    glm::dvec2 halfExtent{1.0};
    bool perspective = true;
    double depthScale = 0.0;
    double depthOffset = 1.0;
};

Projection makeProjection(const scene::Perspective& camera, double aspectRatio) {
    Projection projection;
    const double halfHeight = std::tan(0.5 * camera.yFovRadians);
    projection.halfExtent = {halfHeight * aspectRatio, halfHeight};
    const double zNear = camera.zNear;
    // Reversed: w at the near plane, 0 at the far one or at infinity.
    projection.depthScale = camera.zFar ? zNear / (*camera.zFar - zNear) : 0.0;
    projection.depthOffset = camera.zFar ? *camera.zFar * projection.depthScale : zNear;
    return projection;
}

Projection makeProjection(const scene::Orthographic& camera, double aspectRatio) {
    Projection projection;
    projection.perspective = false;
    // All that the camera sees is in the picture, whatever the picture's shape.
    const double halfHeight = std::max<double>(camera.yMag, camera.xMag / aspectRatio);
    projection.halfExtent = {halfHeight * aspectRatio, halfHeight};
    projection.depthScale = 1.0 / (camera.zFar - camera.zNear);
    projection.depthOffset = camera.zFar * projection.depthScale;
    return projection;
}

}  // namespace

shared::CameraData makeCameraData(const scene::Camera& camera, glm::ivec2 size,
                                  glm::dvec2 samplePosition) {
    const double aspectRatio = static_cast<double>(size.x) / size.y;
    const Projection projection = std::visit(
        [&](const auto& lens) { return makeProjection(lens, aspectRatio); }, camera.projection);
    // Where in normalised device coordinates, y up, the sample lies from its pixel's centre.
    const glm::dvec2 jitter =
        2.0 * (samplePosition - 0.5) * glm::dvec2(1.0, -1.0) / glm::dvec2(size);

    glm::dmat4 clipFromView(0.0);  // Columns.
    clipFromView[0][0] = 1.0 / projection.halfExtent.x;
    clipFromView[1][1] = 1.0 / projection.halfExtent.y;
    clipFromView[2][2] = projection.depthScale;
    clipFromView[3][2] = projection.depthOffset;
    if (projection.perspective) {
        clipFromView[2][3] = -1.0;
        clipFromView[2][0] = jitter.x;
        clipFromView[2][1] = jitter.y;
    } else {
        clipFromView[3][3] = 1.0;
        clipFromView[3][0] = -jitter.x;
        clipFromView[3][1] = -jitter.y;
    }

    const glm::dmat4 worldFromView(camera.worldFromCamera);
    const glm::dvec3 right = glm::dvec3(worldFromView[0]) * projection.halfExtent.x;
    const glm::dvec3 up = glm::dvec3(worldFromView[1]) * projection.halfExtent.y;
    const glm::dvec3 forward = -glm::dvec3(worldFromView[2]);
    const glm::dvec3 eye(worldFromView[3]);
    const glm::dvec3 offset = jitter.x * right + jitter.y * up;
    const auto pack = [](const glm::dvec3& v) { return glm::vec4(v, 0.0f); };

    shared::CameraData data{};
    data.clipFromWorld = glm::mat4(clipFromView * glm::inverse(worldFromView));
    if (projection.perspective) {
        data.rayOrigin = pack(eye);
        data.rayDirection = pack(forward + offset);
        data.rayDirectionX = pack(right);
        data.rayDirectionY = pack(up);
        // d = (offset - scale t) / t
        data.depth = {projection.depthOffset, 0.0, projection.depthScale, 1.0};
    } else {
        data.rayOrigin = pack(eye + offset);
        data.rayOriginX = pack(right);
        data.rayOriginY = pack(up);
        data.rayDirection = pack(forward);
        // d = offset - scale t
        data.depth = {projection.depthOffset / projection.depthScale, -1.0 / projection.depthScale,
                      1.0, 0.0};
    }
    return data;
}

}  // namespace polylume
