// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/camera_projection.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/test_scenes.hpp"

namespace polylume {
namespace {

constexpr glm::ivec2 kSize{160, 90};
constexpr double kAspect = 160.0 / 90.0;
constexpr double kNear = 0.25;
constexpr double kFar = 40.0;

// The block is float: its matrix and its rays round at 6e-8, over a handful of operations, of
// lengths of a few metres.
constexpr double kTolerance = 1e-5;

scene::Camera makeLens(bool perspective, bool finite, float xMag = 1.0f) {
    scene::Camera camera = test::makeCamera({1.0f, 2.0f, 3.0f}, {-2.0f, 0.5f, -1.0f});
    if (perspective) {
        scene::Perspective lens;
        lens.yFovRadians = 0.9f;
        lens.zNear = static_cast<float>(kNear);
        if (finite) lens.zFar = static_cast<float>(kFar);
        camera.projection = lens;
    } else {
        scene::Orthographic lens;
        lens.xMag = xMag;
        lens.yMag = 1.5f;
        lens.zNear = static_cast<float>(kNear);
        lens.zFar = static_cast<float>(kFar);
        camera.projection = lens;
    }
    return camera;
}

const std::vector<scene::Camera>& allLenses() {
    static const std::vector<scene::Camera> lenses = {makeLens(true, false), makeLens(true, true),
                                                      makeLens(false, true),
                                                      makeLens(false, true, 5.0f)};
    return lenses;
}

/// Normalised device coordinates and depth of a world point.
glm::dvec3 project(const shared::CameraData& data, const glm::dvec3& point) {
    const glm::dvec4 clip = glm::dmat4(data.clipFromWorld) * glm::dvec4(point, 1.0);
    return glm::dvec3(clip) / clip.w;
}

glm::dvec3 pointOnRay(const shared::CameraData& data, const glm::dvec2& ndc, double distance) {
    const glm::dvec4 origin = glm::dvec4(data.rayOrigin) + ndc.x * glm::dvec4(data.rayOriginX) +
                              ndc.y * glm::dvec4(data.rayOriginY);
    const glm::dvec4 direction = glm::dvec4(data.rayDirection) +
                                 ndc.x * glm::dvec4(data.rayDirectionX) +
                                 ndc.y * glm::dvec4(data.rayDirectionY);
    return glm::dvec3(origin + distance * direction);
}

double distanceFromDepth(const shared::CameraData& data, double depth) {
    return (data.depth.x + data.depth.y * depth) / (data.depth.z + data.depth.w * depth);
}

/// The point `distance` along the axis that a lens shows at `ndc`, by the definition of field of
/// view and magnification alone.
glm::dvec3 pointSeenAt(const scene::Camera& camera, const glm::dvec2& ndc, double distance) {
    glm::dvec2 halfExtent(0.0);
    if (const auto* lens = std::get_if<scene::Perspective>(&camera.projection)) {
        halfExtent = distance * std::tan(0.5 * lens->yFovRadians) * glm::dvec2(kAspect, 1.0);
    } else {
        // Both extents fit into the picture.
        const auto& orthographic = std::get<scene::Orthographic>(camera.projection);
        halfExtent = std::max<double>(orthographic.yMag, orthographic.xMag / kAspect) *
                     glm::dvec2(kAspect, 1.0);
    }
    return glm::dvec3(glm::dmat4(camera.worldFromCamera) *
                      glm::dvec4(ndc * halfExtent, -distance, 1.0));
}

/// Normalised device coordinates of a position in pixels from the top left.
glm::dvec2 ndcOf(const glm::dvec2& position) {
    return (2.0 * position / glm::dvec2(kSize) - 1.0) * glm::dvec2(1.0, -1.0);
}

TEST(CameraProjectionTest, pointsFallWhereTheLensShowsThem) {
    for (const scene::Camera& camera : allLenses()) {
        const shared::CameraData data = makeCameraData(camera, kSize, {0.5, 0.5});
        for (const double distance : {0.3, 1.0, 7.0, 39.0}) {
            for (const glm::dvec2 ndc :
                 {glm::dvec2(0, 0), glm::dvec2(-1, 1), glm::dvec2(0.7, -0.4)}) {
                const glm::dvec3 projected = project(data, pointSeenAt(camera, ndc, distance));
                EXPECT_NEAR(projected.x, ndc.x, kTolerance) << distance;
                EXPECT_NEAR(projected.y, ndc.y, kTolerance) << distance;
            }
        }
    }
}

TEST(CameraProjectionTest, raysLeadBackToProjectedPoints) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const scene::Camera& camera : allLenses()) {
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec2 sample(uniform(generator), uniform(generator));
            const shared::CameraData data = makeCameraData(camera, kSize, sample);
            const double distance = 0.3 + 10.0 * uniform(generator);
            const glm::dvec2 ndc(2.0 * uniform(generator) - 1.0, 2.0 * uniform(generator) - 1.0);
            const glm::dvec3 point = pointSeenAt(camera, ndc, distance);
            const glm::dvec3 projected = project(data, point);
            const glm::dvec3 back =
                pointOnRay(data, glm::dvec2(projected), distanceFromDepth(data, projected.z));
            ASSERT_LT(glm::distance(back, point), kTolerance * distance + 2e-6 * kFar);
        }
    }
}

TEST(CameraProjectionTest, aSampleIsSeenAtItsPixelsCentre) {
    const glm::dvec2 pixel(37, 61);
    for (const scene::Camera& camera : allLenses()) {
        for (const glm::dvec2 sample :
             {glm::dvec2(0.5, 0.5), glm::dvec2(0, 0), glm::dvec2(0.875, 0.125)}) {
            const shared::CameraData data = makeCameraData(camera, kSize, sample);
            const glm::dvec3 point = pointSeenAt(camera, ndcOf(pixel + sample), 4.0);
            const glm::dvec3 projected = project(data, point);
            const glm::dvec2 center = ndcOf(pixel + 0.5);
            EXPECT_NEAR(projected.x, center.x, kTolerance) << sample.x << ", " << sample.y;
            EXPECT_NEAR(projected.y, center.y, kTolerance) << sample.x << ", " << sample.y;
            EXPECT_LT(glm::distance(pointOnRay(data, center, 4.0), point), kTolerance);
        }
    }
}

TEST(CameraProjectionTest, aQuarterOfAPixelIsFarAboveTheTolerance) {
    // The twin of the test above: the jitter that it checks is not lost in its tolerance.
    const shared::CameraData centred = makeCameraData(allLenses()[0], kSize, {0.5, 0.5});
    const shared::CameraData jittered = makeCameraData(allLenses()[0], kSize, {0.75, 0.5});
    const glm::dvec3 point = pointSeenAt(allLenses()[0], {0.2, 0.3}, 4.0);
    EXPECT_NEAR(project(centred, point).x - project(jittered, point).x, 2.0 * 0.25 / kSize.x,
                kTolerance);
}

TEST(CameraProjectionTest, depthIsOneAtTheNearPlaneAndZeroAtTheFarOne) {
    for (const scene::Camera& camera : allLenses()) {
        const shared::CameraData data = makeCameraData(camera, kSize, {0.5, 0.5});
        const auto depthAt = [&](double distance) {
            return project(data, pointSeenAt(camera, {0.1, 0.2}, distance)).z;
        };
        EXPECT_NEAR(depthAt(kNear), 1.0, 1e-5);
        const auto* lens = std::get_if<scene::Perspective>(&camera.projection);
        const bool infinite = lens != nullptr && !lens->zFar;
        // Of an infinite projection: near / distance.
        EXPECT_NEAR(depthAt(kFar), infinite ? kNear / kFar : 0.0, 1e-6);
        EXPECT_GT(depthAt(1.0), depthAt(2.0));
        EXPECT_NEAR(distanceFromDepth(data, 1.0), kNear, 1e-5);
        if (infinite) continue;
        EXPECT_NEAR(distanceFromDepth(data, 0.0), kFar, 1e-4);
    }
}

TEST(CameraProjectionTest, depthKeepsItsDigitsFarAway) {
    // What reversed depth is for: neighbours in float at 10 km are less than a millionth of the
    // distance apart.
    const shared::CameraData data = makeCameraData(makeLens(true, false), kSize, {0.5, 0.5});
    const auto depth = static_cast<float>(kNear / 1e4);
    const double first = distanceFromDepth(data, depth);
    const double second = distanceFromDepth(data, std::nextafter(depth, 1.0f));
    EXPECT_NEAR(first, 1e4, 1e-2);
    EXPECT_LT(std::abs(second - first), 1e-6 * first);
}

}  // namespace
}  // namespace polylume
