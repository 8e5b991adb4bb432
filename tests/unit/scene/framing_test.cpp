// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// frameCamera() and defaultRig().

#include "scene/framing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lights/light_outline.hpp"
#include "scene/default_lighting.hpp"

namespace polylume::scene {
namespace {

const Bounds kCube{glm::vec3(-1), glm::vec3(1)};
const Bounds kTower{glm::vec3(5, 0, 5), glm::vec3(6, 20, 6)};
const Bounds kPlate{glm::vec3(-30, 0, -20), glm::vec3(30, 0, 20)};
const Bounds kSpeck{glm::vec3(1e-4f), glm::vec3(2e-4f)};

/// x and y from -1 to 1 in the picture, z the distance in front of the camera.
glm::vec3 project(const Camera& camera, const glm::vec3& point, float aspectRatio) {
    const glm::vec3 local = glm::transpose(glm::mat3(camera.worldFromCamera)) *
                            (point - glm::vec3(camera.worldFromCamera[3]));
    const float tangent = std::tan(0.5f * std::get<Perspective>(camera.projection).yFovRadians);
    return {local.x / (-local.z * tangent * aspectRatio), local.y / (-local.z * tangent), -local.z};
}

glm::vec3 corner(const Bounds& bounds, int i) {
    return {i & 1 ? bounds.maximum.x : bounds.minimum.x,
            i & 2 ? bounds.maximum.y : bounds.minimum.y,
            i & 4 ? bounds.maximum.z : bounds.minimum.z};
}

TEST(FramingTest, fillsThePictureLessAMargin) {
    for (const Bounds& bounds : {kCube, kTower, kPlate, kSpeck}) {
        for (const float aspectRatio : {0.4f, 1.0f, 16.0f / 9.0f, 3.0f}) {
            const Camera camera = frameCamera(bounds, aspectRatio);
            const auto& perspective = std::get<Perspective>(camera.projection);
            glm::vec2 extent(0.0f);
            for (int i = 0; i < 8; ++i) {
                const glm::vec3 projected = project(camera, corner(bounds, i), aspectRatio);
                extent = glm::max(extent, glm::abs(glm::vec2(projected)));
                EXPECT_GT(projected.z, perspective.zNear);
                EXPECT_LT(projected.z, *perspective.zFar);
            }
            // One direction is filled to 0.88, as far as single precision lets the projection say.
            EXPECT_NEAR(std::max(extent.x, extent.y), 0.88f, 1e-3f);
            EXPECT_GT(perspective.zNear, 0.0f);
        }
    }
}

TEST(FramingTest, looksFromTheFrontAndAboveWithoutRolling) {
    const Camera camera = frameCamera(kCube, 1.0f);
    const glm::vec3 forward = -glm::vec3(camera.worldFromCamera[2]);
    EXPECT_LT(forward.z, -0.5f);
    EXPECT_LT(forward.y, 0.0f);
    EXPECT_NEAR(camera.worldFromCamera[0].y, 0.0f, 1e-6f);
    EXPECT_NEAR(glm::determinant(glm::mat3(camera.worldFromCamera)), 1.0f, 1e-5f);
}

TEST(FramingTest, takesEmptyAndPointlikeBounds) {
    for (const Bounds& bounds : {Bounds{}, Bounds{glm::vec3(3), glm::vec3(3)}}) {
        const Camera camera = frameCamera(bounds, 1.5f);
        const auto& perspective = std::get<Perspective>(camera.projection);
        EXPECT_TRUE(std::isfinite(camera.worldFromCamera[3].x));
        EXPECT_GT(*perspective.zFar, perspective.zNear);
        EXPECT_EQ(defaultRig(bounds, camera).size(), 3u);
    }
}

TEST(DefaultRigTest, facesTheObjectFromOutsideThePicture) {
    for (const Bounds& bounds : {kCube, kTower, kPlate, kSpeck}) {
        for (const float aspectRatio : {0.6f, 1.0f, 16.0f / 9.0f}) {
            const Camera camera = frameCamera(bounds, aspectRatio);
            const std::vector<AreaLight> lights = defaultRig(bounds, camera);
            ASSERT_EQ(lights.size(), 3u);
            for (const AreaLight& light : lights) {
                SCOPED_TRACE(light.name);
                const auto& contour = std::get<PolygonLight>(light.shape).contours.front();
                const glm::vec3 toObject =
                    glm::normalize(bounds.center() - 0.5f * (contour[0] + contour[2]));
                EXPECT_NEAR(glm::dot(glm::normalize(glm::vec3(areaVector(contour))), toObject),
                            1.0f, 1e-5f);
                // All corners in front of the camera lie beyond one same side of the picture.
                int beyond[4] = {0, 0, 0, 0}, inFront = 0;
                for (const glm::vec3& point : contour) {
                    const glm::vec3 projected = project(camera, point, aspectRatio);
                    if (projected.z <= 0.0f) continue;
                    ++inFront;
                    beyond[0] += projected.x > 1.0f;
                    beyond[1] += projected.x < -1.0f;
                    beyond[2] += projected.y > 1.0f;
                    beyond[3] += projected.y < -1.0f;
                }
                EXPECT_TRUE(beyond[0] == inFront || beyond[1] == inFront || beyond[2] == inFront ||
                            beyond[3] == inFront);
            }
        }
    }
}

TEST(DefaultRigTest, lightsAlikeAtEverySize) {
    // Solid angle times radiance, the irradiance toward each light for small lights.
    const auto irradiance = [](const Bounds& bounds) {
        double sum = 0.0;
        for (const AreaLight& light : defaultRig(bounds, frameCamera(bounds, 1.5f))) {
            const auto& polygon = std::get<PolygonLight>(light.shape);
            const auto& contour = polygon.contours.front();
            const double distance = glm::length(0.5f * (contour[0] + contour[2]) - bounds.center());
            sum +=
                polygon.radiance.g * 0.5 * glm::length(areaVector(contour)) / (distance * distance);
        }
        return sum;
    };
    EXPECT_NEAR(irradiance(kSpeck) / irradiance(kCube), 1.0, 1e-3);
    EXPECT_GT(irradiance(kCube), 3000.0);
    EXPECT_LT(irradiance(kCube), 12000.0);
}

}  // namespace
}  // namespace polylume::scene
