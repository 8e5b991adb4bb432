// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>

#include "brdf/ggx.hpp"
#include "reference_scenes.hpp"
#include "support/test_scenes.hpp"

// What a surface reflects of light from everywhere is its albedo.
namespace polylume::reference {
namespace {

constexpr double kNits = 1000.0;

/// Of white metal, seen from `eye`.
class GgxAlbedo {
  public:
    GgxAlbedo(const scene::Camera& camera, double roughness)
        : eye_(camera.worldFromCamera[3]), roughness_(roughness) {}

    glm::dvec3 operator()(const glm::dvec3& position, const glm::dvec3& normal) const {
        const double cosine = glm::dot(glm::normalize(normal), glm::normalize(eye_ - position));
        const double clamped = std::clamp(cosine, brdf::kMinCosThetaView, 1.0);
        return glm::dvec3(kNits * brdf::Ggx().reflectance(roughness_, clamped).albedo);
    }

  private:
    glm::dvec3 eye_;
    double roughness_;
};

/// A light 10^5 times as wide as it is high above the floor.
PolygonLight makeSky() {
    return testing::rectangleLight({0, 1, 0}, {1e5f, 0, 0}, {0, 0, 1e5f}, glm::vec3(kNits));
}

testing::Agreement compareUnderSky(float roughness, const glm::vec3& eye, double claimed) {
    const scene::Scene scene =
        testing::sceneOf(test::makeFloor(8.0f), testing::whiteMetal(roughness));
    const scene::Camera camera = test::makeCamera(eye, {0, 0, 0}, 0.4f);
    ReferenceOptions options = testing::plainOptions({32, 24}, 256);
    options.extraLights.polygons = {makeSky()};
    return testing::compare(testing::trace(scene, camera, options), GgxAlbedo(camera, claimed));
}

TEST(GgxUnderTheSkyTest, reflectsItsAlbedo) {
    const std::vector<glm::vec3> eyes = {{0, 0.9f, 3.0f}, {0, 5, 1}};
    for (const float roughness : {0.1f, 0.35f, 0.6f, 1.0f}) {
        for (const glm::vec3& eye : eyes) {
            const std::string name =
                "r = " + std::to_string(roughness) + (eye.y < 1.0f ? ", flat" : ", steep");
            testing::expectAgreement(compareUnderSky(roughness, eye, roughness), name);
        }
    }
}

TEST(GgxUnderTheSkyTest, theComparisonFindsARoughnessOffByATenth) {
    EXPECT_LT(compareUnderSky(0.6f, {0, 0.9f, 3.0f}, 0.7).shareWithin4, 0.9);
}

/// A sphere within a cube whose walls are lights.
FloatImage traceFurnace(const scene::Material& material, const scene::Camera& camera,
                        int pathCount) {
    const scene::Scene scene = testing::sceneOf(test::makeSphere(24), material);
    ReferenceOptions options = testing::plainOptions({32, 32}, pathCount);
    for (const testing::Side& side : testing::cubeSides(3.0f)) {
        options.extraLights.polygons.push_back(
            testing::rectangleLight(side.center, side.halfX, side.halfY, glm::vec3(kNits)));
    }
    return testing::trace(scene, camera, options);
}

TEST(FurnaceTest, whiteLambertIsInvisible) {
    const scene::Camera camera = test::makeCamera({0, 0.5f, 2.9f}, {0, 0, 0}, 0.6f);
    const FloatImage image = traceFurnace(testing::lambertMaterial(glm::vec3(1.0f)), camera, 256);
    const testing::Agreement agreement = testing::compare(
        image, [](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(kNits); });
    testing::expectAgreement(agreement, "Lambert");
    // The twin.
    const testing::Agreement twin = testing::compare(
        image, [](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(1.002 * kNits); });
    EXPECT_GT(std::abs(twin.relativeMeanError), 1e-3);
}

TEST(FurnaceTest, ggxLosesWhatItsAlbedoLacks) {
    const scene::Camera camera = test::makeCamera({0, 0.5f, 2.9f}, {0, 0, 0}, 0.6f);
    for (const float roughness : {0.2f, 0.5f, 1.0f}) {
        const FloatImage image = traceFurnace(testing::whiteMetal(roughness), camera, 128);
        const testing::Agreement agreement = testing::compare(image, GgxAlbedo(camera, roughness));
        const std::string name = "r = " + std::to_string(roughness);
        EXPECT_GT(agreement.pixelCount, 300u) << name;
        EXPECT_GE(agreement.shareWithin4, 0.995) << name;
        EXPECT_LE(std::abs(agreement.meanErrorInDeviations), 3.0) << name;
        EXPECT_LE(std::abs(agreement.relativeMeanError), 1e-3) << name;
        RecordProperty(name, std::to_string(agreement.meanErrorInDeviations) +
                                 " deviations of the mean, " +
                                 std::to_string(agreement.relativeMeanError));
    }
}

TEST(FurnaceTest, inABallOrATubeThatShinesInwards) {
    // No walls: the light is the furnace.
    const scene::Camera camera = test::makeCamera({0, 0.5f, 2.9f}, {0, 0, 0}, 0.6f);
    LightSet ball, tube;
    ball.spheres = {{{0.1f, 0.2f, 0.3f}, 5.0f, glm::vec3(kNits), true}};
    tube.tubes = {{{-3, 0.2f, 0.3f}, {4, 0, 1}, 2.0f, glm::vec3(kNits), true}};
    for (const LightSet& lights : {ball, tube}) {
        for (const float roughness : {0.1f, 0.4f, 1.0f}) {
            const scene::Scene scene =
                testing::sceneOf(test::makeSphere(24), testing::whiteMetal(roughness));
            ReferenceOptions options = testing::plainOptions({32, 32}, 128);
            options.extraLights = lights;
            const FloatImage image = testing::trace(scene, camera, options);
            const testing::Agreement agreement =
                testing::compare(image, GgxAlbedo(camera, roughness));
            const std::string name = "r = " + std::to_string(roughness);
            EXPECT_GT(agreement.pixelCount, 300u) << name;
            EXPECT_GE(agreement.shareWithin4, 0.99) << name;
            EXPECT_LE(std::abs(agreement.relativeMeanError), 1e-3) << name;
        }
    }
}

TEST(FurnaceTest, aFarBallIsTheDiskThatItLooksLike) {
    const scene::Camera camera = test::makeCamera({0, 2.0f, 4.0f}, {0, 0, 0}, 0.6f);
    for (const float roughness : {0.05f, 0.3f, 0.8f}) {
        const scene::Scene scene =
            testing::sceneOf(test::makeFloor(1.0f), testing::whiteMetal(roughness));
        ReferenceOptions options = testing::plainOptions({32, 24}, 1024);
        const glm::vec3 center(0, 2e3f, -4e3f);
        const glm::vec3 toward = -glm::normalize(center);
        const glm::vec3 side(1, 0, 0);
        options.extraLights.spheres = {{center, 2e2f, glm::vec3(kNits)}};
        const FloatImage ball = testing::trace(scene, camera, options);
        // As the cone is seen: sine of the angle 1 / sqrt(500), so the disk is a little larger.
        const float radius = 2e2f / std::sqrt(1.0f - 4e4f / glm::dot(center, center));
        options.extraLights = {};
        options.extraLights.ellipses = {
            {center, radius * side, radius * glm::cross(toward, side), glm::vec3(kNits)}};
        options.seed = 1;
        const FloatImage disk = testing::trace(scene, camera, options);
        double sumBall = 0.0, sumDisk = 0.0, square = 0.0;
        for (std::size_t i = 0; i < ball.pixels.size() / ball.channelCount(); ++i) {
            sumBall += testing::color(ball, i).r;
            sumDisk += testing::color(disk, i).r;
            const double a = testing::layer(ball, "standardError", i).r;
            const double b = testing::layer(disk, "standardError", i).r;
            square += a * a + b * b;
        }
        // The floor moves under the disk by 1e-3 of the distance.
        EXPECT_NEAR(sumBall / sumDisk, 1.0, 4.0 * std::sqrt(square) / sumDisk + 1e-3) << roughness;
        EXPECT_GT(sumDisk, 1.0);
    }
}

}  // namespace
}  // namespace polylume::reference
