// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include "reference_scenes.hpp"
#include "scene/emissive_lights.hpp"
#include "support/test_scenes.hpp"

// An emissive surface gives its light once, whichever way it is followed.
namespace polylume::reference {
namespace {

constexpr float kNits = 1000.0f;
constexpr float kAlbedo = 0.5f;
const glm::vec3 kCenter(0.1f, 1.0f, 0.0f), kHalfX(0.5f, 0.0f, 0.0f), kHalfY(0.0f, 0.0f, 0.4f);

/// A panel that reflects nothing and emits downwards, over a floor.
scene::Scene panelOverFloor() {
    scene::Scene scene =
        testing::sceneOf(test::makeFloor(4.0f), testing::lambertMaterial(glm::vec3(kAlbedo)));
    scene::Material panel = testing::lambertMaterial(glm::vec3(0.0f));
    panel.emissiveFactor = glm::vec3(kNits);
    testing::addMesh(scene, testing::rectangleMesh(kCenter, kHalfX, kHalfY), panel);
    return scene;
}

/// The picture from above, from where the panel is not seen, against the closed form.
testing::Agreement agreementOf(const scene::Scene& scene, int depth, int pathCount = 1024) {
    ReferenceOptions options = testing::plainOptions({24, 24}, pathCount);
    options.shadows = true;
    options.depth = depth;
    const PolygonLight light = testing::rectangleLight(kCenter, kHalfX, kHalfY, glm::vec3(kNits));
    return testing::compare(
        testing::trace(scene, testing::topCamera(1.5f), options),
        [&](const glm::dvec3& position, const glm::dvec3&) {
            return glm::dvec3(kAlbedo * kNits * testing::formFactor(light, position));
        });
}

TEST(EmissiveLightTest, lightsByBouncesWithoutAreaLights) {
    // Directions that meet the panel by chance: noisier than directions toward a light.
    testing::expectAgreement(agreementOf(panelOverFloor(), 2, 16384), "bounces");
}

TEST(EmissiveLightTest, lightsOnceByAreaLightsAtEveryDepth) {
    scene::Scene scene = panelOverFloor();
    scene::addEmissiveLights(scene);
    ASSERT_EQ(scene.areaLights.size(), 1u);
    for (const int depth : {1, 2, 4}) {
        testing::expectAgreement(agreementOf(scene, depth), "depth " + std::to_string(depth));
    }
}

TEST(EmissiveLightTest, theComparisonFindsLightThatIsCountedTwice) {
    scene::Scene scene = panelOverFloor();
    scene::addEmissiveLights(scene);
    scene.materials[1].emissionIsLight = false;
    EXPECT_NEAR(agreementOf(scene, 2).relativeMeanError, 1.0, 0.05);
}

TEST(EmissiveLightTest, theCameraSeesTheSurfaceAsBefore) {
    scene::Scene scene = panelOverFloor();
    // From below, filled by the panel.
    const scene::Camera camera = test::makeCamera({0.1f, 0.2f, 0.0f}, {0.1f, 1.0f, 0.001f}, 0.3f);
    ReferenceOptions options = testing::plainOptions({8, 8}, 16);
    options.hideLights = false;
    const FloatImage before = testing::trace(scene, camera, options);
    scene::addEmissiveLights(scene);
    const FloatImage after = testing::trace(scene, camera, options);
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_EQ(testing::color(after, i), glm::dvec3(kNits));
        EXPECT_EQ(testing::color(before, i), testing::color(after, i));
    }
    // The light itself would stand before the surface, as the other does.
    std::get<PolygonLight>(scene.areaLights[0].shape).shownBySurface = false;
    std::get<PolygonLight>(scene.areaLights[0].shape).radiance *= 2.0f;
    for (glm::vec3& vertex : std::get<PolygonLight>(scene.areaLights[0].shape).contours[0]) {
        vertex.y -= 0.1f;
    }
    EXPECT_EQ(testing::color(testing::trace(scene, camera, options), 27), glm::dvec3(2.0 * kNits));
}

}  // namespace
}  // namespace polylume::reference
