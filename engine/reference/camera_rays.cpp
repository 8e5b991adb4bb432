// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/camera_rays.hpp"

#include "view/camera_projection.hpp"

namespace polylume::reference {

CameraRays::CameraRays(const scene::Camera& camera, glm::ivec2 size, glm::dvec2 samplePosition)
    : data_(makeCameraData(camera, size, samplePosition)), size_(size) {
    if (const auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        nearest_ = lens->zNear;
        farthest_ = lens->zFar ? *lens->zFar : std::numeric_limits<double>::infinity();
    } else {
        const auto& orthographic = std::get<scene::Orthographic>(camera.projection);
        nearest_ = orthographic.zNear;
        farthest_ = orthographic.zFar;
    }
}

Ray CameraRays::ray(int x, int y) const {
    const glm::dvec2 ndc = (2.0 * (glm::dvec2(x, y) + 0.5) / size_ - 1.0) * glm::dvec2(1.0, -1.0);
    const auto at = [&](const glm::vec4& base, const glm::vec4& perX, const glm::vec4& perY) {
        return glm::dvec3(base) + ndc.x * glm::dvec3(perX) + ndc.y * glm::dvec3(perY);
    };
    Ray ray;
    ray.origin = at(data_.rayOrigin, data_.rayOriginX, data_.rayOriginY);
    ray.direction = at(data_.rayDirection, data_.rayDirectionX, data_.rayDirectionY);
    ray.nearest = nearest_;
    ray.farthest = farthest_;
    ray.isFromCamera = true;
    // Half a pixel is 1 / size in normalised device coordinates.
    ray.originPerX = glm::dvec3(data_.rayOriginX) / size_.x;
    ray.originPerY = glm::dvec3(data_.rayOriginY) / size_.y;
    ray.directionPerX = glm::dvec3(data_.rayDirectionX) / size_.x;
    ray.directionPerY = glm::dvec3(data_.rayDirectionY) / size_.y;
    return ray;
}

}  // namespace polylume::reference
