// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/camera_rays.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/test_scenes.hpp"
#include "view/camera_projection.hpp"

namespace polylume::reference {
namespace {

constexpr glm::ivec2 kSize{20, 12};

scene::Camera perspectiveCamera() {
    scene::Camera camera = test::makeCamera({1, 2, 3}, {-0.5f, 0.2f, -1}, 0.7f);
    std::get<scene::Perspective>(camera.projection).zFar = 50.0f;
    return camera;
}

scene::Camera orthographicCamera() {
    scene::Camera camera = perspectiveCamera();
    scene::Orthographic lens;
    lens.xMag = 4.0f;
    lens.yMag = 1.5f;
    lens.zNear = 0.5f;
    lens.zFar = 20.0f;
    camera.projection = lens;
    return camera;
}

const glm::dvec2 kPositions[] = {{0.5, 0.5}, {0.125, 0.625}, {0.9, 0.0}};

/// The camera's coordinates of a point.
glm::dvec3 inCamera(const scene::Camera& camera, const glm::dvec3& world) {
    return glm::inverse(glm::dmat4(camera.worldFromCamera)) * glm::dvec4(world, 1.0);
}

/// Single precision in the camera's matrix and block, of values of up to 10.
constexpr double kRounding = 5e-6;

TEST(CameraRaysTest, goThroughTheirPlaceInThePictureOfAPerspectiveCamera) {
    const scene::Camera camera = perspectiveCamera();
    const double halfHeight = std::tan(0.35);
    const double halfWidth = halfHeight * kSize.x / kSize.y;
    for (const glm::dvec2& position : kPositions) {
        const CameraRays rays(camera, kSize, position);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const Ray ray = rays.ray(x, y);
                const glm::dvec3 p = inCamera(camera, ray.origin + 3.0 * ray.direction);
                EXPECT_NEAR(p.z, -3.0, kRounding);  // Distances are along the axis.
                EXPECT_NEAR(p.x / 3.0, (2 * (x + position.x) / kSize.x - 1) * halfWidth, kRounding);
                EXPECT_NEAR(p.y / 3.0, (1 - 2 * (y + position.y) / kSize.y) * halfHeight,
                            kRounding);
            }
        }
        EXPECT_FLOAT_EQ(rays.ray(0, 0).nearest, 0.1f);
        EXPECT_FLOAT_EQ(rays.ray(0, 0).farthest, 50.0f);
    }
}

TEST(CameraRaysTest, goThroughTheirPlaceInThePictureOfAnOrthographicCamera) {
    const scene::Camera camera = orthographicCamera();
    // The width decides: 4 / 1.5 is wider than the picture.
    const double halfWidth = 4.0, halfHeight = 4.0 * kSize.y / kSize.x;
    for (const glm::dvec2& position : kPositions) {
        const CameraRays rays(camera, kSize, position);
        for (int y = 0; y < kSize.y; ++y) {
            for (int x = 0; x < kSize.x; ++x) {
                const Ray ray = rays.ray(x, y);
                const glm::dvec3 p = inCamera(camera, ray.origin + 3.0 * ray.direction);
                EXPECT_NEAR(p.z, -3.0, kRounding);
                EXPECT_NEAR(p.x, (2 * (x + position.x) / kSize.x - 1) * halfWidth, kRounding);
                EXPECT_NEAR(p.y, (1 - 2 * (y + position.y) / kSize.y) * halfHeight, kRounding);
            }
        }
        EXPECT_FLOAT_EQ(rays.ray(0, 0).nearest, 0.5f);
        EXPECT_FLOAT_EQ(rays.ray(0, 0).farthest, 20.0f);
    }
}

TEST(CameraRaysTest, meetWhatTheRasteriserPutsAtThePixelsCenter) {
    for (const scene::Camera& camera : {perspectiveCamera(), orthographicCamera()}) {
        for (const glm::dvec2& position : kPositions) {
            const CameraRays rays(camera, kSize, position);
            const glm::dmat4 clipFromWorld(makeCameraData(camera, kSize, position).clipFromWorld);
            for (const glm::ivec2 pixel : {glm::ivec2(0, 0), {19, 11}, {7, 4}}) {
                for (const double distance : {0.6, 4.0, 19.0}) {
                    const Ray ray = rays.ray(pixel.x, pixel.y);
                    const glm::dvec4 clip =
                        clipFromWorld * glm::dvec4(ray.origin + distance * ray.direction, 1.0);
                    const glm::dvec2 ndc = glm::dvec2(clip) / clip.w;
                    // In pixels, at distances of 0.6 and up.
                    EXPECT_NEAR((ndc.x + 1) * 0.5 * kSize.x, pixel.x + 0.5, 1e-4);
                    EXPECT_NEAR((1 - ndc.y) * 0.5 * kSize.y, pixel.y + 0.5, 1e-4);
                }
            }
        }
    }
}

TEST(CameraRaysTest, knowTheirNeighbours) {
    for (const scene::Camera& camera : {perspectiveCamera(), orthographicCamera()}) {
        const CameraRays rays(camera, kSize, {0.3, 0.6});
        const Ray ray = rays.ray(6, 5), right = rays.ray(7, 5), up = rays.ray(6, 4);
        EXPECT_TRUE(ray.isFromCamera);
        // Half a pixel each, twice.
        EXPECT_LT(glm::length(ray.direction + 2.0 * ray.directionPerX - right.direction), 1e-12);
        EXPECT_LT(glm::length(ray.direction + 2.0 * ray.directionPerY - up.direction), 1e-12);
        EXPECT_LT(glm::length(ray.origin + 2.0 * ray.originPerX - right.origin), 1e-12);
        EXPECT_LT(glm::length(ray.origin + 2.0 * ray.originPerY - up.origin), 1e-12);
        EXPECT_GT(
            glm::length(right.direction - ray.direction) + glm::length(right.origin - ray.origin),
            0.01);
    }
}

}  // namespace
}  // namespace polylume::reference
