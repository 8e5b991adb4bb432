// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/framing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polylume::scene {
namespace {

constexpr double kYFov = 0.52;         // 30 degrees: a short telephoto, as products are taken.
constexpr double kAzimuth = 0.52;      // From +Z toward +X.
constexpr double kElevation = 0.26;    // Above the horizon.
constexpr double kFilledShare = 0.88;  // Of the picture's width or height.

/// The eight corners in the camera's axes, seen from the origin: x right, y up, z away from the
/// viewer.
struct CornerExtent {
    double left = -INFINITY, right = -INFINITY, bottom = -INFINITY, top = -INFINITY;
    double nearest = INFINITY, farthest = -INFINITY;
};

CornerExtent measure(const Bounds& bounds, const glm::dmat3& axes, double tanX, double tanY) {
    CornerExtent extent;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 position(corner & 1 ? bounds.maximum.x : bounds.minimum.x,
                                  corner & 2 ? bounds.maximum.y : bounds.minimum.y,
                                  corner & 4 ? bounds.maximum.z : bounds.minimum.z);
        const glm::dvec3 offset = position - glm::dvec3(bounds.center());
        const double x = glm::dot(axes[0], offset);
        const double y = glm::dot(axes[1], offset);
        const double depth = -glm::dot(axes[2], offset);
        extent.right = std::max(extent.right, x - tanX * depth);
        extent.left = std::max(extent.left, -x - tanX * depth);
        extent.top = std::max(extent.top, y - tanY * depth);
        extent.bottom = std::max(extent.bottom, -y - tanY * depth);
        extent.nearest = std::min(extent.nearest, depth);
        extent.farthest = std::max(extent.farthest, depth);
    }
    return extent;
}

}  // namespace

Camera frameCamera(const Bounds& bounds, float aspectRatio) {
    Bounds framed = bounds;
    if (framed.isEmpty()) framed = {glm::vec3(-0.5f), glm::vec3(0.5f)};
    if (!(framed.radius() > 0.0f)) {
        framed = {framed.center() - glm::vec3(0.5f), framed.center() + glm::vec3(0.5f)};
    }
    const glm::dvec3 back(std::sin(kAzimuth) * std::cos(kElevation), std::sin(kElevation),
                          std::cos(kAzimuth) * std::cos(kElevation));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back));
    const glm::dmat3 axes(right, glm::cross(back, right), back);

    // A corner (x, depth) is inside where |x - cx| <= t (depth - cd): the largest of x - t depth
    // and -x - t depth bound the camera's place (cx, cd) from both sides, and cd is the nearest
    // that fits.
    const double tanY = kFilledShare * std::tan(0.5 * kYFov);
    const double tanX = tanY * aspectRatio;
    const CornerExtent extent = measure(framed, axes, tanX, tanY);
    const double centerX = 0.5 * (extent.right - extent.left);
    const double centerY = 0.5 * (extent.top - extent.bottom);
    const double cameraDepth = std::min(-(extent.right + extent.left) / (2.0 * tanX),
                                        -(extent.top + extent.bottom) / (2.0 * tanY));
    const glm::dvec3 position =
        glm::dvec3(framed.center()) + axes * glm::dvec3(centerX, centerY, -cameraDepth);

    Camera camera;
    camera.name = "framed";
    camera.worldFromCamera = glm::mat4(glm::mat3(axes));
    camera.worldFromCamera[3] = glm::vec4(glm::vec3(position), 1.0f);
    Perspective perspective;
    perspective.yFovRadians = static_cast<float>(kYFov);
    const double nearest = extent.nearest - cameraDepth;
    const double farthest = extent.farthest - cameraDepth;
    // Room on both sides, so that rounding clips nothing; never so near that depth loses its bits.
    perspective.zNear = static_cast<float>(std::max(0.5 * nearest, 1e-3 * farthest));
    perspective.zFar = static_cast<float>(1.5 * farthest);
    camera.projection = perspective;
    return camera;
}

}  // namespace polylume::scene
