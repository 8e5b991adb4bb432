// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "camera_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace polylume::viewer {
namespace {

constexpr double kPi = glm::pi<double>();

scene::Camera lookFrom(const glm::vec3& eye, const glm::vec3& target,
                       const glm::vec3& up = {0.0f, 1.0f, 0.0f}) {
    scene::Camera camera;
    camera.worldFromCamera = glm::inverse(glm::lookAt(eye, target, up));
    camera.projection = scene::Perspective{};
    return camera;
}

class CameraControlTest : public ::testing::Test {
  protected:
    CameraControlTest() { control_.reset(start_, bounds_); }

    /// Until it has come to its goal; the number of updates.
    int settle() {
        int count = 0;
        while (control_.isMoving() && count < 1000) {
            control_.update(0.016);
            ++count;
        }
        return count;
    }
    glm::dvec3 eye() const { return glm::dvec3(control_.camera().worldFromCamera[3]); }
    glm::dvec3 back() const { return glm::dvec3(control_.camera().worldFromCamera[2]); }
    glm::dvec3 right() const { return glm::dvec3(control_.camera().worldFromCamera[0]); }

    scene::Bounds bounds_{{-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}};
    scene::Camera start_ = lookFrom({0.3f, 1.2f, 5.0f}, {0.1f, 0.0f, -0.2f});
    CameraControl control_;
};

TEST_F(CameraControlTest, aCameraThatIsNotMovedIsTheScenesToTheLastBit) {
    EXPECT_TRUE(control_.isExact());
    EXPECT_EQ(control_.camera().worldFromCamera, start_.worldFromCamera);
}

TEST_F(CameraControlTest, poseAndMatrixAgree) {
    // Also of a camera that leans, and of one that looks straight down.
    for (const scene::Camera& camera :
         {start_, lookFrom({2.0f, -1.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, {0.4f, 1.0f, 0.1f}),
          lookFrom({0.0f, 4.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.6f, 0.0f, -0.8f})}) {
        control_.reset(camera, bounds_);
        const glm::dmat3 axes = control_.pose().axes();
        const glm::dmat3 wanted(glm::mat3(camera.worldFromCamera));
        for (int i = 0; i < 3; ++i) {
            // The matrix is of single precision.
            EXPECT_LT(glm::length(axes[i] - wanted[i]), 1e-6) << "axis " << i;
        }
        EXPECT_LT(glm::length(control_.pose().eye() - glm::dvec3(camera.worldFromCamera[3])), 1e-6);
    }
}

TEST_F(CameraControlTest, orbitKeepsTheDistanceToThePivotAndTheHorizonLevel) {
    const CameraPose before = control_.pose();
    control_.orbit({0.3, 0.1});
    settle();
    EXPECT_FALSE(control_.isExact());
    EXPECT_NEAR(glm::length(eye() - before.pivot), before.distance, 1e-5);
    EXPECT_NEAR(right().y, 0.0, 1e-6);
    // A drag to the right takes the camera to the left, one down takes it up.
    EXPECT_NEAR(control_.pose().yaw, before.yaw - 0.3 * kPi, 1e-9);
    EXPECT_NEAR(control_.pose().pitch, before.pitch + 0.1 * kPi, 1e-9);
}

TEST_F(CameraControlTest, nothingFlipsAtThePoles) {
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 rightBefore = right();
        control_.orbit({0.0, i < 100 ? 0.05 : -0.05});
        control_.update(0.016);
        EXPECT_GT(glm::dot(rightBefore, right()), 0.999) << "step " << i;
        EXPECT_GE(control_.camera().worldFromCamera[1].y, 0.0f) << "step " << i;
        EXPECT_LE(std::abs(control_.pose().pitch), 0.5 * kPi);
    }
}

TEST_F(CameraControlTest, panMovesWithTheMouse) {
    const CameraPose before = control_.pose();
    control_.pan({0.25, 0.0});
    settle();
    const double height = 2.0 * before.distance * std::tan(0.5 * scene::Perspective{}.yFovRadians);
    EXPECT_NEAR(glm::dot(control_.pose().pivot - before.pivot, before.axes()[0]), -0.25 * height,
                1e-9);
    EXPECT_NEAR(control_.pose().yaw, before.yaw, 1e-12);
}

TEST_F(CameraControlTest, theWheelGoesNearerAndNeverThrough) {
    const double before = control_.pose().distance;
    control_.dolly(1.0);
    settle();
    EXPECT_LT(control_.pose().distance, before);
    control_.dolly(1000.0);
    settle();
    EXPECT_GT(control_.pose().distance, 0.0);
    control_.dolly(-1e6);
    settle();
    EXPECT_TRUE(std::isfinite(control_.pose().distance));
}

TEST_F(CameraControlTest, lookTurnsAroundTheEye) {
    const glm::dvec3 before = control_.pose().eye();
    const glm::dvec3 backBefore = back();
    control_.look({0.4, -0.2});
    settle();
    EXPECT_LT(glm::length(control_.pose().eye() - before), 1e-9);
    EXPECT_LT(glm::dot(back(), backBefore), 0.99);
}

TEST_F(CameraControlTest, flightGoesWhereItLooks) {
    const CameraPose before = control_.pose();
    control_.fly({0.0, 0.0, 1.0}, 0.5);
    settle();
    const glm::dvec3 way = control_.pose().eye() - before.eye();
    EXPECT_LT(glm::length(way + 0.5 * control_.speed() * before.axes()[2]), 1e-9);
    const double speed = control_.speed();
    control_.changeSpeed(2.0);
    EXPECT_GT(control_.speed(), speed);
}

TEST_F(CameraControlTest, focusSeesAllOfABox) {
    const scene::Bounds box{{2.0f, 2.0f, 2.0f}, {2.4f, 2.2f, 2.6f}};
    control_.focus(box);
    settle();
    const CameraPose pose = control_.pose();
    EXPECT_LT(glm::length(pose.pivot - glm::dvec3(box.center())), 1e-6);
    const glm::dmat3 worldToView = glm::transpose(pose.axes());
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p(corner & 1 ? box.maximum.x : box.minimum.x,
                           corner & 2 ? box.maximum.y : box.minimum.y,
                           corner & 4 ? box.maximum.z : box.minimum.z);
        const glm::dvec3 view = worldToView * (p - pose.eye());
        EXPECT_LT(std::abs(view.y / view.z), std::tan(0.5 * scene::Perspective{}.yFovRadians));
    }
}

TEST_F(CameraControlTest, theWayBackEndsAtTheSceneCameraExactly) {
    control_.orbit({2.7, 0.3});
    settle();
    control_.moveTo(start_);
    EXPECT_FALSE(control_.isExact());
    const int count = settle();
    EXPECT_TRUE(control_.isExact());
    EXPECT_EQ(control_.camera().worldFromCamera, start_.worldFromCamera);
    // Half a second at 60 frames a second, and no jump.
    EXPECT_LT(count, 40);
    EXPECT_GT(count, 5);
}

TEST_F(CameraControlTest, aMovedCameraCutsNothingOff) {
    control_.orbit({0.1, 0.0});
    settle();
    const scene::Camera camera = control_.camera();
    const auto& lens = std::get<scene::Perspective>(camera.projection);
    EXPECT_FALSE(lens.zFar.has_value());
    EXPECT_LE(lens.zNear, 0.01f);
}

TEST_F(CameraControlTest, anOrthographicCameraZooms) {
    scene::Camera camera = start_;
    camera.projection = scene::Orthographic{2.0f, 1.0f, 0.0f, 10.0f};
    control_.reset(camera, bounds_);
    control_.dolly(3.0);
    settle();
    const scene::Camera nearer = control_.camera();
    const auto& lens = std::get<scene::Orthographic>(nearer.projection);
    EXPECT_LT(lens.yMag, 1.0f);
    EXPECT_NEAR(lens.xMag / lens.yMag, 2.0f, 1e-5f);
}

TEST_F(CameraControlTest, emptyScenesAreNoTrouble) {
    control_.reset(start_, scene::Bounds{});
    control_.focus(scene::Bounds{});
    control_.dolly(5.0);
    control_.fly({1.0, 1.0, 1.0}, 0.1);
    settle();
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            EXPECT_TRUE(std::isfinite(control_.camera().worldFromCamera[column][row]));
        }
    }
}

}  // namespace
}  // namespace polylume::viewer
