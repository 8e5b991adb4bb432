// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "camera_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

namespace polylume::viewer {
namespace {

constexpr double kPi = glm::pi<double>();
/// A hair from the pole, where a turn around the vertical would be one around the optical axis.
constexpr double kSteepest = 0.4995 * kPi;
/// A drag over the height of the picture turns by half a circle.
constexpr double kTurnOfDrag = kPi;
constexpr double kDollyOfStep = 0.88;
constexpr double kSpeedOfStep = 1.25;
/// Seconds in which a movement comes closer to its goal by a factor of e.
constexpr double kSmoothness = 0.045;

double wrapAngle(double angle) {
    return angle - 2.0 * kPi * std::round(angle / (2.0 * kPi));
}

double radiusOf(const scene::Bounds& bounds) {
    const double radius = bounds.radius();
    return std::isfinite(radius) && radius > 0.0 ? radius : 1.0;
}

}  // namespace

glm::dmat3 CameraPose::axes() const {
    const glm::dvec3 back(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                          std::cos(yaw) * std::cos(pitch));
    const glm::dvec3 levelRight(std::cos(yaw), 0.0, -std::sin(yaw));
    const glm::dvec3 levelUp = glm::cross(back, levelRight);
    return {std::cos(roll) * levelRight + std::sin(roll) * levelUp,
            std::cos(roll) * levelUp - std::sin(roll) * levelRight, back};
}

CameraPose CameraControl::poseOf(const scene::Camera& camera) const {
    const glm::dmat4 world(camera.worldFromCamera);
    const glm::dvec3 right(world[0]), up(world[1]), back(world[2]), eye(world[3]);
    CameraPose pose;
    pose.pitch = std::asin(std::clamp(back.y, -1.0, 1.0));
    // Straight up or down the direction of the view says nothing of the yaw; the right does.
    const bool isSteep = std::hypot(back.x, back.z) < 1e-6;
    pose.yaw = isSteep ? std::atan2(-right.z, right.x) : std::atan2(back.x, back.z);
    const glm::dvec3 levelRight(std::cos(pose.yaw), 0.0, -std::sin(pose.yaw));
    pose.roll = std::atan2(-glm::dot(up, levelRight), glm::dot(right, levelRight));
    // The pivot is where the view passes the middle of the scene, which lies ahead in most.
    const double radius = radiusOf(bounds_);
    const glm::dvec3 center =
        bounds_.isEmpty() ? eye - radius * back : glm::dvec3(bounds_.center());
    pose.distance = std::max(glm::dot(eye - center, back), 0.25 * radius);
    pose.pivot = eye - pose.distance * back;
    return pose;
}

void CameraControl::reset(const scene::Camera& camera, const scene::Bounds& bounds) {
    bounds_ = bounds;
    lens_ = camera;
    pose_ = goal_ = poseOf(camera);
    exact_ = camera.worldFromCamera;
    isAtGoal_ = true;
    speed_ = 0.5 * radiusOf(bounds);
}

void CameraControl::moveTo(const scene::Camera& camera) {
    lens_ = camera;
    goal_ = poseOf(camera);
    exact_ = camera.worldFromCamera;
    isAtGoal_ = false;
}

void CameraControl::changed() {
    exact_.reset();
    isAtGoal_ = false;
}

double CameraControl::halfHeight() const {
    if (const auto* lens = std::get_if<scene::Orthographic>(&lens_.projection)) {
        return lens->yMag / goal_.zoom;
    }
    return goal_.distance *
           std::tan(0.5 * std::get<scene::Perspective>(lens_.projection).yFovRadians);
}

void CameraControl::orbit(const glm::dvec2& drag) {
    goal_.yaw -= kTurnOfDrag * drag.x;
    goal_.pitch = std::clamp(goal_.pitch + kTurnOfDrag * drag.y, -kSteepest, kSteepest);
    changed();
}

void CameraControl::pan(const glm::dvec2& drag) {
    const glm::dmat3 axes = goal_.axes();
    goal_.pivot += 2.0 * halfHeight() * (drag.y * axes[1] - drag.x * axes[0]);
    changed();
}

void CameraControl::dolly(double steps) {
    const double factor = std::pow(kDollyOfStep, steps);
    const double radius = radiusOf(bounds_);
    if (std::holds_alternative<scene::Orthographic>(lens_.projection)) {
        goal_.zoom = std::clamp(goal_.zoom / factor, 1e-3, 1e4);
    } else {
        goal_.distance = std::clamp(goal_.distance * factor, 1e-3 * radius, 1e3 * radius);
    }
    changed();
}

void CameraControl::look(const glm::dvec2& drag) {
    const glm::dvec3 eye = goal_.eye();
    // A turn by what the drag covers of the view.
    const auto* lens = std::get_if<scene::Perspective>(&lens_.projection);
    const double turn = lens != nullptr ? lens->yFovRadians : 0.8;
    goal_.yaw -= turn * drag.x;
    goal_.pitch = std::clamp(goal_.pitch + turn * drag.y, -kSteepest, kSteepest);
    goal_.pivot = eye - goal_.distance * goal_.axes()[2];
    changed();
}

void CameraControl::fly(const glm::dvec3& direction, double seconds) {
    const glm::dmat3 axes = goal_.axes();
    goal_.pivot +=
        speed_ * seconds * (direction.x * axes[0] + direction.y * axes[1] - direction.z * axes[2]);
    changed();
}

void CameraControl::changeSpeed(double steps) {
    const double radius = radiusOf(bounds_);
    speed_ = std::clamp(speed_ * std::pow(kSpeedOfStep, steps), 1e-3 * radius, 1e2 * radius);
}

void CameraControl::focus(const scene::Bounds& bounds) {
    const scene::Bounds& target = bounds.isEmpty() ? bounds_ : bounds;
    if (!target.isEmpty()) goal_.pivot = glm::dvec3(target.center());
    constexpr double kMargin = 1.15;
    // A light is a small thing, or a point; not so near that nothing around it is seen.
    const double radius = kMargin * std::max(radiusOf(target), 0.02 * radiusOf(bounds_));
    if (auto* lens = std::get_if<scene::Orthographic>(&lens_.projection)) {
        goal_.zoom = lens->yMag / radius;
    } else {
        const double fov = std::get<scene::Perspective>(lens_.projection).yFovRadians;
        goal_.distance = radius / std::sin(std::min(0.5 * fov, 1.2));
    }
    changed();
}

bool CameraControl::update(double seconds) {
    if (isAtGoal_) return false;
    const double step = 1.0 - std::exp(-seconds / kSmoothness);
    // The short way round.
    const double yawLeft = exact_ ? wrapAngle(goal_.yaw - pose_.yaw) : goal_.yaw - pose_.yaw;
    const double rollLeft = wrapAngle(goal_.roll - pose_.roll);
    pose_.pivot += step * (goal_.pivot - pose_.pivot);
    pose_.distance *= std::pow(goal_.distance / pose_.distance, step);
    pose_.zoom *= std::pow(goal_.zoom / pose_.zoom, step);
    pose_.yaw += step * yawLeft;
    pose_.pitch += step * (goal_.pitch - pose_.pitch);
    pose_.roll += step * rollLeft;
    const double turnLeft =
        std::abs(yawLeft) + std::abs(goal_.pitch - pose_.pitch) + std::abs(rollLeft);
    const double wayLeft = glm::length(goal_.pivot - pose_.pivot) / goal_.distance +
                           std::abs(std::log(goal_.distance / pose_.distance)) +
                           std::abs(std::log(goal_.zoom / pose_.zoom));
    // Less than a pixel of a large screen.
    if (turnLeft + wayLeft < 2e-4) {
        pose_ = goal_;
        isAtGoal_ = true;
    }
    return true;
}

scene::Camera CameraControl::camera() const {
    scene::Camera camera = lens_;
    if (isExact()) {
        camera.worldFromCamera = *exact_;
        return camera;
    }
    const glm::dmat3 axes = pose_.axes();
    camera.worldFromCamera = glm::mat4(glm::mat3(axes));
    camera.worldFromCamera[3] = glm::vec4(glm::vec3(pose_.eye()), 1.0f);
    camera.name = "view";
    const auto radius = static_cast<float>(radiusOf(bounds_));
    if (auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        // Nothing is cut off, wherever it goes: depth is reversed and float, which has the bits.
        lens->zNear = std::min(lens->zNear, 1e-3f * radius);
        lens->zFar.reset();
    } else {
        auto& extent = std::get<scene::Orthographic>(camera.projection);
        extent.xMag /= static_cast<float>(pose_.zoom);
        extent.yMag /= static_cast<float>(pose_.zoom);
        const auto reach = static_cast<float>(pose_.distance) + 4.0f * radius;
        extent.zFar = std::max(extent.zFar, reach);
    }
    return camera;
}

}  // namespace polylume::viewer
