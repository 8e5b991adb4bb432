// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/scene_lights.hpp"

#include <gtest/gtest.h>

namespace polylume {
namespace {

/// One light of each shape, every second one two-sided.
scene::Scene sceneOfEveryShape() {
    scene::Scene scene;
    PolygonLight polygon = scene::makeRectangle({}, {2.0f, 1.0f}, {1, 2, 3});
    polygon.texture.emplace();
    EllipseLight ellipse = scene::makeEllipse({}, {1.0f, 1.0f}, {4, 5, 6});
    ellipse.twoSided = true;
    SphereLight sphere;
    sphere.radius = 0.25f;
    TubeLight tube;
    tube.twoSided = true;
    tube.radius = 0.125f;
    scene.areaLights = {{"a", polygon, ""}, {"b", ellipse, ""}, {"c", sphere, ""}, {"d", tube, ""}};
    return scene;
}

TEST(SceneLightsTest, areaLightsKeepTheirShape) {
    const LightSet lights = lightsOf(sceneOfEveryShape(), {});
    ASSERT_EQ(lights.polygons.size(), 1u);
    EXPECT_EQ(lights.polygons[0].contours.front().size(), 4u);
    EXPECT_EQ(lights.polygons[0].radiance, glm::vec3(1, 2, 3));
    EXPECT_FALSE(lights.polygons[0].twoSided);
    EXPECT_TRUE(lights.polygons[0].texture.has_value());
    ASSERT_EQ(lights.ellipses.size(), 1u);
    const EllipseLight& disk = lights.ellipses[0];
    EXPECT_TRUE(disk.twoSided);
    EXPECT_EQ(glm::cross(disk.halfAxisX, disk.halfAxisY), glm::vec3(0, 0, -0.25f));
    ASSERT_EQ(lights.spheres.size(), 1u);
    EXPECT_FALSE(lights.spheres[0].twoSided);
    EXPECT_EQ(lights.spheres[0].radius, 0.25f);
    ASSERT_EQ(lights.tubes.size(), 1u);
    EXPECT_TRUE(lights.tubes[0].twoSided);
    EXPECT_EQ(lights.tubes[0].radius, 0.125f);
}

TEST(SceneLightsTest, twoSidedHoldsForEveryAreaLight) {
    ViewOptions options;
    options.twoSided = true;
    const LightSet lights = lightsOf(sceneOfEveryShape(), options);
    EXPECT_TRUE(lights.polygons.at(0).twoSided);
    EXPECT_TRUE(lights.ellipses.at(0).twoSided);
    EXPECT_TRUE(lights.spheres.at(0).twoSided);
    EXPECT_TRUE(lights.tubes.at(0).twoSided);
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
