// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene/light.hpp"
#include "scene/merge.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kTolerance = 1e-6f;

GltfBuilder withAreaLight(json light, json node = json::object()) {
    GltfBuilder builder;
    builder.document["extensions"]["EXT_lights_area"]["lights"] = json::array({std::move(light)});
    node["extensions"]["EXT_lights_area"]["light"] = 0;
    builder.addNode(std::move(node));
    return builder;
}

GltfBuilder withPunctualLight(json light, json node = json::object()) {
    GltfBuilder builder;
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] =
        json::array({std::move(light)});
    node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    builder.addNode(std::move(node));
    return builder;
}

double area(const std::vector<glm::vec3>& contour, const glm::vec3& towards) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < contour.size(); ++i) {
        sum += glm::cross(glm::dvec3(contour[i]), glm::dvec3(contour[(i + 1) % contour.size()]));
    }
    return 0.5 * glm::dot(sum, glm::dvec3(towards));
}

TEST(AreaLightTest, hasTheDefaultsOfTheExtension) {
    const WarningLog log;
    const AreaLight light = withAreaLight({{"type", "rect"}}).read().areaLights.at(0);
    const auto& rectangle = std::get<PolygonLight>(light.shape);
    EXPECT_EQ(rectangle.radiance, glm::vec3(1000.0f));
    EXPECT_NEAR(area(rectangle.contours.at(0), {0, 0, -1}), 1.0, 1e-6);
    EXPECT_FALSE(rectangle.twoSided);
    EXPECT_FALSE(rectangle.texture.has_value());
    EXPECT_THAT(log.messages, ElementsAre(HasSubstr("no \"rect\"")));
}

TEST(AreaLightTest, readsARectangle) {
    const WarningLog log;
    const AreaLight light = withAreaLight({{"name", "panel"},
                                           {"type", "rect"},
                                           {"color", {1, 0.5, 0.25}},
                                           {"intensity", 5000000000},
                                           {"size", 2},
                                           {"rect", {{"aspect", 1.5}}}})
                                .read()
                                .areaLights.at(0);
    EXPECT_EQ(light.name, "panel");
    // Above the range of 32-bit integers, as tinygltf would read it.
    const auto& rectangle = std::get<PolygonLight>(light.shape);
    EXPECT_EQ(rectangle.radiance, glm::vec3(5e9f, 2.5e9f, 1.25e9f));
    EXPECT_EQ(rectangle.contours.at(0).at(2), glm::vec3(1.5f, 1, 0));
    EXPECT_THAT(log.messages, IsEmpty());
}

TEST(AreaLightTest, takesTheLargestWorldScaleAndTheProductOfRotations) {
    GltfBuilder builder = withAreaLight({{"type", "disk"}, {"size", 0.5}},
                                        {{"scale", {1, -4, 1}}, {"translation", {0, 0, 1}}});
    const float half = std::sqrt(0.5f);
    builder.document["nodes"].push_back(
        {{"children", {0}}, {"scale", {3, 1, 2}}, {"rotation", {half, 0, 0, half}}});
    builder.document["scenes"][0]["nodes"] = {1};
    const AreaLight light = builder.read().areaLights.at(0);
    const auto& disk = std::get<EllipseLight>(light.shape);
    // Columns of the world matrix: lengths 3, 4 and 2.
    EXPECT_NEAR(glm::length(disk.halfAxisX), 1.0f, kTolerance);
    EXPECT_NEAR(glm::length(disk.halfAxisY), 1.0f, kTolerance);
    // A quarter turn about x takes -Z to +Y; (0, 0, 2) goes to (0, -2, 0).
    EXPECT_NEAR(glm::cross(disk.halfAxisX, disk.halfAxisY).y, 1.0f, kTolerance);
    EXPECT_NEAR(disk.center.y, -2.0f, kTolerance);
}

TEST(AreaLightTest, warnsOfFieldsOfOlderDrafts) {
    const WarningLog log;
    withAreaLight({{"type", "disk"}, {"shape", "rect"}, {"luminance", 3}, {"radius", {1}}}).read();
    EXPECT_THAT(log.messages, ElementsAre(HasSubstr("shape is of an older draft"),
                                          HasSubstr("use intensity"), HasSubstr("use size")));
}

TEST(AreaLightTest, contoursTurnCounterClockwiseSeenFromTheEmittingSide) {
    const LightFrame frame{{5, 5, 5}, glm::mat3(1.0f)};
    const PolygonLight rectangle = makeRectangle(frame, {3, 2}, glm::vec3(1.0f));
    EXPECT_THAT(rectangle.contours.at(0), SizeIs(4));
    EXPECT_NEAR(area(rectangle.contours.at(0), {0, 0, -1}), 6.0, 1e-5);
    const EllipseLight ellipse = makeEllipse(frame, {3, 2}, glm::vec3(1.0f));
    EXPECT_EQ(glm::cross(ellipse.halfAxisX, ellipse.halfAxisY), glm::vec3(0, 0, -1.5f));
}

TEST(PunctualLightTest, readsTheThreeKinds) {
    const float half = std::sqrt(0.5f);
    const json node{
        {"rotation", {half, 0, 0, half}}, {"translation", {1, 2, 3}}, {"scale", {2, 2, -3}}};
    const PunctualLight point =
        withPunctualLight(
            {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}, {"range", 7}})
            .read()
            .punctualLights.at(0);
    EXPECT_EQ(point.type, PunctualLightType::point);
    EXPECT_EQ(point.intensity, glm::vec3(40, 20, 0));
    EXPECT_EQ(point.range, 7.0f);
    json straight = node;
    straight.erase("scale");
    const PunctualLight sun =
        withPunctualLight({{"type", "directional"}}, straight).read().punctualLights.at(0);
    EXPECT_EQ(sun.type, PunctualLightType::directional);
    EXPECT_NEAR(sun.direction.y, 1.0f, kTolerance);
    EXPECT_TRUE(std::isinf(sun.range));
    const PunctualLight spot =
        withPunctualLight(
            {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.2}}}}, node)
            .read()
            .punctualLights.at(0);
    EXPECT_EQ(spot.innerConeAngle, 0.1f);
    EXPECT_EQ(spot.outerConeAngle, 0.2f);
    EXPECT_EQ(spot.position, glm::vec3(1, 2, 3));
    // A mirroring scale turns -Z about, as it does for everything that the node carries.
    EXPECT_NEAR(spot.direction.y, -1.0f, kTolerance);
}

TEST(PunctualLightTest, clampsConeAnglesWithAWarning) {
    const WarningLog log;
    const PunctualLight spot =
        withPunctualLight(
            {{"type", "spot"}, {"spot", {{"innerConeAngle", 3}, {"outerConeAngle", 2}}}})
            .read()
            .punctualLights.at(0);
    EXPECT_LT(spot.innerConeAngle, spot.outerConeAngle);
    EXPECT_LE(spot.outerConeAngle, std::numbers::pi_v<float> / 2);
    EXPECT_THAT(log.messages, SizeIs(1));
}

TEST(MergeTest, addsLightsAndTheCamerasOfASceneWithout) {
    Scene lights;
    lights.areaLights.resize(2);
    lights.punctualLights.resize(1);
    lights.cameras.resize(1);
    lights.cameras[0].name = "theirs";
    Scene scene;
    scene.areaLights.resize(1);
    addLightsFrom(scene, lights);
    EXPECT_THAT(scene.areaLights, SizeIs(3));
    EXPECT_THAT(scene.punctualLights, SizeIs(1));
    EXPECT_EQ(scene.cameras.at(0).name, "theirs");
    scene.cameras[0].name = "ours";
    addLightsFrom(scene, lights);
    EXPECT_THAT(scene.cameras, SizeIs(1));
    EXPECT_EQ(scene.cameras[0].name, "ours");
}

}  // namespace
}  // namespace polylume::scene::test
