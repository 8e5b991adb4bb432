// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "reference_scenes.hpp"
#include "support/test_scenes.hpp"

// A closed cube of one Lambert material, where light from everywhere is reflected to everywhere.
namespace polylume::reference {
namespace {

constexpr double kAlbedo = 0.6;
constexpr double kNits = 100.0;

scene::Scene makeCube(const glm::vec3& emission) {
    scene::Scene scene;
    scene.name = "test";
    scene::Material material = testing::lambertMaterial(glm::vec3(kAlbedo));
    material.emissiveFactor = emission;
    for (const testing::Side& side : testing::cubeSides(2.0f)) {
        testing::addMesh(scene, testing::rectangleMesh(side.center, side.halfX, side.halfY),
                         material);
    }
    return scene;
}

ReferenceOptions makeOptions(int depth, int pathCount) {
    ReferenceOptions options = testing::plainOptions({32, 24}, pathCount);
    options.shadows = true;
    options.depth = depth;
    return options;
}

scene::Camera cubeCamera() {
    return test::makeCamera({0.9f, 0.5f, 1.2f}, {-1, -0.4f, -1}, 1.2f);
}

testing::Agreement compareWith(const FloatImage& image, double expected) {
    return testing::compare(
        image, [=](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(expected); });
}

TEST(EmissiveCubeTest, everyDepthAddsOneTerm) {
    // E (1 + rho + rho^2 + ...), without any spread: a cosine-weighted path carries rho exactly.
    const scene::Scene scene = makeCube(glm::vec3(kNits));
    double expected = 0.0;
    for (int depth = 1; depth <= 5; ++depth) {
        expected += kNits * std::pow(kAlbedo, depth - 1);
        const FloatImage image = testing::trace(scene, cubeCamera(), makeOptions(depth, 16));
        std::size_t offCount = 0;
        const std::size_t pixelCount = image.pixels.size() / image.channelCount();
        for (std::size_t i = 0; i < pixelCount; ++i) {
            // Directions and positions in single precision change no value.
            if (!(std::abs(testing::color(image, i).r - expected) <= 1e-5 * expected)) ++offCount;
        }
        EXPECT_EQ(offCount, 0u) << "depth " << depth;
    }
}

TEST(LitCubeTest, everyDepthAddsOneTerm) {
    // The walls are covered with lights that the camera does not see: E (rho + rho^2 + ...).
    const scene::Scene scene = makeCube(glm::vec3(0.0f));
    double expected = 0.0;
    for (int depth = 1; depth <= 3; ++depth) {
        expected += kNits * std::pow(kAlbedo, depth);
        ReferenceOptions options = makeOptions(depth, 128);
        for (const testing::Side& side : testing::cubeSides(2.0f)) {
            options.extraLights.polygons.push_back(
                testing::rectangleLight(side.center, side.halfX, side.halfY, glm::vec3(kNits)));
        }
        const FloatImage image = testing::trace(scene, cubeCamera(), options);
        testing::expectAgreement(compareWith(image, expected), "depth " + std::to_string(depth));
        // The twin: a term left out or too many.
        const double next = kNits * std::pow(kAlbedo, depth + 1);
        EXPECT_LT(compareWith(image, expected + next).shareWithin4, 0.1);
    }
}

TEST(LitCubeTest, aMixOfLobesKeepsTheEnergy) {
    // A lossless wall would be white metal of roughness 0: a mirror passes everything on, so that
    // all depths but the light at the last give E.
    scene::Scene scene = makeCube(glm::vec3(kNits));
    for (scene::Material& material : scene.materials) {
        const glm::vec3 emission = material.emissiveFactor;
        material = testing::whiteMetal(0.0f);
        material.emissiveFactor = emission;
    }
    const FloatImage image = testing::trace(scene, cubeCamera(), makeOptions(3, 64));
    const testing::Agreement agreement = compareWith(image, 3.0 * kNits);
    // GGX at the floor of alpha, 1e-4, loses 1e-4 at grazing views.
    EXPECT_NEAR(agreement.relativeMeanError, 0.0, 1e-3);
}

TEST(HalfTransparentWallTest, bouncesMeetItsShare) {
    // A floor below a wide emissive ceiling of coverage c: the light that arrives is c E, but for
    // what passes beside it, 1e-5.
    const float coverage = 0.3f;
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(3.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    scene::Material ceiling = testing::lambertMaterial(glm::vec3(0.0f));
    ceiling.emissiveFactor = glm::vec3(kNits);
    ceiling.alphaMode = scene::AlphaMode::blend;
    ceiling.baseColorFactor.a = coverage;
    testing::addMesh(scene, testing::rectangleMesh({0, 2, 0}, {700, 0, 0}, {0, 0, 900}), ceiling);
    const scene::Camera camera = test::makeCamera({0, 1.5f, 1.0f}, {0, 0, 0}, 0.8f);
    const FloatImage image = testing::trace(scene, camera, makeOptions(2, 1024));
    // Each replicate meets 19 or 20 times out of 64, so that all of a pixel may be the same: the
    // pixels' errors are no guide.
    const testing::Agreement agreement = compareWith(image, kAlbedo * coverage * kNits);
    EXPECT_LE(std::abs(agreement.relativeMeanError), 1e-3);
    EXPECT_GT(std::abs(compareWith(image, kAlbedo * 0.302 * kNits).relativeMeanError), 1e-3);
}

}  // namespace
}  // namespace polylume::reference
