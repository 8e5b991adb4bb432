// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/scene_lights.hpp"

#include <gtest/gtest.h>

namespace polylume {
namespace {

TEST(SceneLightsTest, areaLightsKeepTheirShape) {
    scene::Scene scene;
    scene.areaLights.resize(2);
    scene.areaLights[0].radiance = {1, 2, 3};
    scene.areaLights[1].shape = scene::AreaLightShape::disk;
    scene.areaLights[1].twoSided = true;
    const LightSet lights = lightsOf(scene, {});
    ASSERT_EQ(lights.polygons.size(), 1u);
    EXPECT_EQ(lights.polygons[0].contours.front().size(), 4u);
    EXPECT_EQ(lights.polygons[0].radiance, glm::vec3(1, 2, 3));
    EXPECT_FALSE(lights.polygons[0].twoSided);
    ASSERT_EQ(lights.ellipses.size(), 1u);
    const EllipseLight& disk = lights.ellipses[0];
    EXPECT_TRUE(disk.twoSided);
    EXPECT_EQ(glm::cross(disk.halfAxisX, disk.halfAxisY), glm::vec3(0, 0, -0.25f));
}

TEST(SceneLightsTest, twoSidedHoldsForEveryAreaLight) {
    scene::Scene scene;
    scene.areaLights.resize(3);
    scene.areaLights[1].twoSided = true;
    scene.areaLights[2].shape = scene::AreaLightShape::disk;
    ViewOptions options;
    options.twoSided = true;
    const LightSet lights = lightsOf(scene, options);
    for (const PolygonLight& light : lights.polygons) EXPECT_TRUE(light.twoSided);
    for (const EllipseLight& light : lights.ellipses) EXPECT_TRUE(light.twoSided);
}

TEST(SceneLightsTest, extraLightsComeBesideTheScenes) {
    scene::Scene scene;
    scene.areaLights.resize(1);
    ViewOptions options;
    options.extraLights = {{PolygonLight{}}, {PunctualLight{}}, {EllipseLight{}}};
    const LightSet lights = lightsOf(scene, options);
    EXPECT_EQ(lights.polygons.size(), 2u);
    EXPECT_EQ(lights.ellipses.size(), 1u);
    EXPECT_EQ(lights.punctuals.size(), 1u);
}

TEST(SceneLightsTest, punctualLightsKeepEveryValue) {
    scene::Scene scene;
    scene::PunctualLight light;
    light.position = {1, 2, 3};
    light.direction = {0, -1, 0};
    light.intensity = {4, 5, 6};
    light.range = 7.0f;
    light.innerConeAngle = 0.1f;
    light.outerConeAngle = 0.2f;
    for (const auto type : {scene::PunctualLightType::directional, scene::PunctualLightType::point,
                            scene::PunctualLightType::spot}) {
        light.type = type;
        scene.punctualLights.push_back(light);
    }
    const LightSet lights = lightsOf(scene, {});
    ASSERT_EQ(lights.punctuals.size(), 3u);
    EXPECT_EQ(lights.punctuals[0].kind, PunctualLightKind::directional);
    EXPECT_EQ(lights.punctuals[1].kind, PunctualLightKind::point);
    EXPECT_EQ(lights.punctuals[2].kind, PunctualLightKind::spot);
    for (const PunctualLight& made : lights.punctuals) {
        EXPECT_EQ(made.position, light.position);
        EXPECT_EQ(made.direction, light.direction);
        EXPECT_EQ(made.intensity, light.intensity);
        EXPECT_EQ(made.range, light.range);
        EXPECT_EQ(made.innerConeAngle, light.innerConeAngle);
        EXPECT_EQ(made.outerConeAngle, light.outerConeAngle);
    }
}

}  // namespace
}  // namespace polylume
