// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "lights/light_image_sampling.hpp"
#include "lights/light_outline.hpp"
#include "polylume/light.hpp"
#include "scene/gltf_reader.hpp"
#include "unit/scene/polylume_light_files.hpp"

namespace polylume::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kTolerance = 1e-6f;

template <typename Shape>
Shape readShape(const GltfBuilder& builder) {
    return std::get<Shape>(builder.read().areaLights.at(0).shape);
}

void expectNear(const glm::vec3& found, const glm::vec3& expected, float tolerance = kTolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "axis " << i;
}

TEST(PolylumeLightTest, hasTheDefaultsOfTheExtension) {
    const WarningLog log;
    const auto rectangle = readShape<PolygonLight>(withLight({{"type", "rect"}}));
    EXPECT_EQ(rectangle.radiance, glm::vec3(1000.0f));
    EXPECT_FALSE(rectangle.twoSided);
    EXPECT_FALSE(rectangle.texture.has_value());
    EXPECT_FALSE(rectangle.shownBySurface);
    EXPECT_EQ(areaVector(rectangle.contours.at(0)), glm::dvec3(0.0, 0.0, -2.0));
    const auto ellipse = readShape<EllipseLight>(withLight({{"type", "ellipse"}}));
    EXPECT_EQ(glm::cross(ellipse.halfAxisX, ellipse.halfAxisY), glm::vec3(0.0f, 0.0f, -0.25f));
    EXPECT_EQ(readShape<SphereLight>(withLight({{"type", "sphere"}})).radius, 0.5f);
    const auto tube = readShape<TubeLight>(withLight({{"type", "tube"}}));
    EXPECT_EQ(tube.radius, 0.01f);
    EXPECT_EQ(tube.start, glm::vec3(-0.5f, 0.0f, 0.0f));
    EXPECT_EQ(tube.end, glm::vec3(0.5f, 0.0f, 0.0f));
    EXPECT_THAT(log.messages, IsEmpty());
}

TEST(PolylumeLightTest, readsEveryValueInTheWorld) {
    const float half = std::sqrt(0.5f);
    // A quarter turn about y takes X to -Z and -Z to -X; mirroring does nothing.
    const json node{{"translation", {1, 2, 3}},
                    {"rotation", {0, half, 0, half}},
                    {"scale", {1, -2, 0.5}},
                    {"name", "node"}};
    const json common{{"color", {1, 0.5, 0}}, {"intensity", 600}, {"twoSided", true}};
    const auto with = [&](json shape) {
        shape.update(common);
        return withLight(std::move(shape), node);
    };
    const auto rectangle =
        readShape<PolygonLight>(with({{"type", "rect"}, {"rect", {{"width", 3}, {"height", 2}}}}));
    EXPECT_TRUE(rectangle.twoSided);
    EXPECT_EQ(rectangle.radiance, glm::vec3(600, 300, 0));
    expectNear(rectangle.contours.at(0).at(0), {1, 0, 6}, 1e-5f);
    expectNear(rectangle.contours.at(0).at(2), {1, 4, 0}, 1e-5f);
    expectNear(glm::vec3(areaVector(rectangle.contours.at(0))), {-48, 0, 0}, 1e-4f);

    const auto ellipse = readShape<EllipseLight>(
        with({{"type", "ellipse"}, {"ellipse", {{"width", 3}, {"height", 2}}}}));
    EXPECT_TRUE(ellipse.twoSided);
    expectNear(ellipse.center, {1, 2, 3});
    expectNear(ellipse.halfAxisX, {0, 0, -3}, 1e-5f);
    expectNear(glm::cross(ellipse.halfAxisX, ellipse.halfAxisY), {-6, 0, 0}, 1e-5f);

    const auto sphere =
        readShape<SphereLight>(with({{"type", "sphere"}, {"sphere", {{"radius", 0.25}}}}));
    EXPECT_TRUE(sphere.twoSided);
    expectNear(sphere.center, {1, 2, 3});
    EXPECT_NEAR(sphere.radius, 0.5f, kTolerance);

    const auto tube = readShape<TubeLight>(
        with({{"type", "tube"}, {"tube", {{"length", 2}, {"radius", 0.125}}}}));
    EXPECT_TRUE(tube.twoSided);
    expectNear(tube.start, {1, 2, 5}, 1e-5f);
    expectNear(tube.end, {1, 2, 1}, 1e-5f);
    EXPECT_NEAR(tube.radius, 0.25f, kTolerance);
}

TEST(PolylumeLightTest, carriesItsNameAndPlace) {
    const AreaLight named = withLight(polygonLight()).read().areaLights.at(0);
    EXPECT_EQ(named.name, "sign");
    EXPECT_EQ(named.place, "scene.gltf: POLYLUME_lights_area.lights[0] \"sign\" at nodes[0]");
    const AreaLight other =
        withLight({{"type", "tube"}}, {{"name", "lamp"}}).read().areaLights.at(0);
    EXPECT_EQ(other.name, "lamp");
}

TEST(PolylumeLightTest, winsOverTheOtherExtensionOnTheSameNode) {
    GltfBuilder builder = withLight({{"type", "sphere"}});
    builder.document["extensions"]["EXT_lights_area"]["lights"] = json::array({{{"type", "disk"}}});
    builder.document["nodes"][0]["extensions"]["EXT_lights_area"]["light"] = 0;
    const Scene scene = builder.read();
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_TRUE(std::holds_alternative<SphereLight>(scene.areaLights[0].shape));
}

TEST(PolylumeLightTest, aReaderWithoutTheExtensionTakesTheOther) {
    GltfBuilder builder = withLight({{"type", "sphere"}});
    builder.document["extensions"]["EXT_lights_area"]["lights"] = json::array({{{"type", "disk"}}});
    builder.document["nodes"][0]["extensions"]["EXT_lights_area"]["light"] = 0;
    builder.document["extensionsUsed"] = {"UNKNOWN_lights", "EXT_lights_area"};
    for (json* holder : {&builder.document, &builder.document["nodes"][0]}) {
        json& extensions = (*holder)["extensions"];
        extensions["UNKNOWN_lights"] = extensions["POLYLUME_lights_area"];
        extensions.erase("POLYLUME_lights_area");
    }
    const WarningLog log;
    const Scene scene = builder.read();
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_TRUE(std::holds_alternative<EllipseLight>(scene.areaLights[0].shape));
    EXPECT_THAT(log.messages, ElementsAre(HasSubstr("UNKNOWN_lights")));
}

TEST(PolylumeLightTest, polygonsGoThroughTheWholeMatrix) {
    json contours = kSquare;
    contours.push_back(json::parse("[[0.5,0,0], [0,0.5,0], [-0.5,-0.5,0]]"));
    json node{{"matrix", {2, 0, 0, 0, 1, 3, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}};
    const auto light = readShape<PolygonLight>(withLight(polygonLight(contours), node));
    ASSERT_THAT(light.contours, SizeIs(2));
    expectNear(light.contours[0][0], {2, 3, 7});
    expectNear(light.contours[0][1], {4, 9, 7});
    EXPECT_NEAR(areaVector(light.contours[0]).z, -48.0, 1e-5);
    // 0.375 of area, turned the other way, times the determinant.
    EXPECT_NEAR(areaVector(light.contours[1]).z, 2.0 * 0.375 * 6.0, 1e-5);
}

TEST(PolylumeLightTest, mirroredPolygonsKeepTheirEmittingSide) {
    // Along X the side stays at -Z, along Z it goes to +Z.
    const auto alongX = readShape<PolygonLight>(withLight(polygonLight(), {{"scale", {-1, 1, 1}}}));
    EXPECT_LT(areaVector(alongX.contours[0]).z, 0.0);
    const auto alongZ = readShape<PolygonLight>(withLight(polygonLight(), {{"scale", {1, 1, -1}}}));
    EXPECT_GT(areaVector(alongZ.contours[0]).z, 0.0);
}

TEST(PolylumeLightTest, theTextureOfARectangleIsUprightFromTheEmittingSide) {
    GltfBuilder builder = withLight(
        {{"type", "rect"}, {"rect", {{"width", 4}, {"height", 2}}}, {"texture", {{"index", 0}}}});
    addTexture(builder, {{"wrapS", 33648}, {"wrapT", 33071}});
    const auto light = readShape<PolygonLight>(builder);
    ASSERT_TRUE(light.texture.has_value());
    EXPECT_EQ(light.texture->wrapU, TextureWrap::mirroredRepeat);
    EXPECT_EQ(light.texture->wrapV, TextureWrap::clampToEdge);
    // From -Z, +X is to the left.
    EXPECT_EQ(textureCoordinates(*light.texture, {2, 1, 0}), glm::dvec2(0, 0));
    EXPECT_EQ(textureCoordinates(*light.texture, {-2, -1, 0}), glm::dvec2(1, 1));
    // Red and green, blue and white.
    expectNear(glm::vec3(sampleImage(*light.texture, {0.25, 0.25})), {1, 0, 0});
    expectNear(glm::vec3(sampleImage(*light.texture, {0.75, 0.25})), {0, 1, 0});
    expectNear(glm::vec3(sampleImage(*light.texture, {0.25, 0.75})), {0, 0, 1});
}

TEST(PolylumeLightTest, theTextureOfAPolygonFollowsItsCoordinates) {
    json light = polygonLight();
    light["polygon"]["texCoords"] = json::parse("[[[3.5,-7], [3.5,-8], [3,-8], [3,-7]]]");
    light["texture"] = {{"index", 0}};
    for (const json& node : {json{{"scale", {2, 3, 1}}}, json{{"scale", {-2, 3, 1}}}}) {
        GltfBuilder builder = withLight(light, node);
        addTexture(builder);
        const auto read = readShape<PolygonLight>(builder);
        ASSERT_TRUE(read.texture.has_value());
        EXPECT_EQ(read.texture->wrapU, TextureWrap::repeat);
        const double side = node["scale"][0].get<double>();
        const glm::dvec2 first = textureCoordinates(*read.texture, {side * -1.0, -3, 0});
        const glm::dvec2 third = textureCoordinates(*read.texture, {side * 1.0, 3, 0});
        // But for whole periods.
        EXPECT_NEAR(first.x - std::floor(first.x), 0.5, 1e-6);
        EXPECT_NEAR(third.x - first.x, -0.5, 1e-6);
        EXPECT_NEAR(third.y - first.y, -1.0, 1e-6);
    }
}

TEST(PolylumeLightTest, texturesAreSharedBetweenLights) {
    GltfBuilder builder = withLight({{"type", "rect"}, {"texture", {{"index", 0}}}});
    addTexture(builder);
    builder.document["nodes"].push_back(builder.document["nodes"][0]);
    builder.document["scenes"][0]["nodes"] = {0, 1};
    const Scene scene = builder.read();
    ASSERT_THAT(scene.areaLights, SizeIs(2));
    EXPECT_EQ(std::get<PolygonLight>(scene.areaLights[0].shape).texture->image,
              std::get<PolygonLight>(scene.areaLights[1].shape).texture->image);
}

TEST(PolylumeLightTest, readsTexturesFromGlbAndFromDataUris) {
    GltfBuilder builder = withLight({{"type", "rect"}, {"texture", {{"index", 0}}}});
    addTexture(builder);
    const Scene glb = readBytes("scene.glb", builder.glb());
    EXPECT_EQ(std::get<PolygonLight>(glb.areaLights.at(0).shape).texture->image->size,
              glm::ivec2(2));
    const auto light = readShape<PolygonLight>(withLight(
        {{"type", "rect"}, {"texture", {{"uri", "data:image/png;base64," + base64(pngBytes())}}}}));
    EXPECT_EQ(light.texture->image->size, glm::ivec2(2));
    EXPECT_EQ(light.texture->wrapU, TextureWrap::clampToEdge);
}

TEST(PolylumeLightTest, readsLinearTexturesBeyondOne) {
    FloatImage image;
    image.width = 2;
    image.height = 1;
    image.channelNames = {"R", "G", "B"};
    image.pixels = {0.5f, 0.25f, 40.0f, -1.0f, NAN, 2.0f};
    const GltfBuilder builder =
        withLight({{"name", "film"}, {"type", "rect"}, {"texture", {{"uri", "a%20panel.exr"}}}});
    std::filesystem::create_directories("PolylumeLightTest.readsLinearTexturesBeyondOne");
    writeExr("PolylumeLightTest.readsLinearTexturesBeyondOne/a panel.exr", image,
             ExrPrecision::single);
    const WarningLog log;
    const auto light = readShape<PolygonLight>(builder);
    EXPECT_THAT(light.texture->image->texels,
                ElementsAre(glm::vec3(0.5f, 0.25f, 40.0f), glm::vec3(0.0f, 0.0f, 2.0f)));
    EXPECT_THAT(log.messages, ElementsAre(testing::AllOf(HasSubstr("\"film\""),
                                                         HasSubstr("negative or not finite"))));
}

TEST(PolylumeLightTest, eightBitTexturesAreDecodedFromSrgb) {
    PixelImage picture;
    picture.width = 1;
    picture.height = 1;
    picture.channelCount = 3;
    picture.pixels = {64, 128, 255};
    std::filesystem::create_directories("PolylumeLightTest.eightBitTexturesAreDecodedFromSrgb");
    writePng("PolylumeLightTest.eightBitTexturesAreDecodedFromSrgb/a.png", picture, {});
    const auto light =
        readShape<PolygonLight>(withLight({{"type", "rect"}, {"texture", {{"uri", "a.png"}}}}));
    expectNear(light.texture->image->texels.at(0),
               {linearFromSrgb(64 / 255.0f), linearFromSrgb(128 / 255.0f), 1.0f});
}

TEST(PolylumeLightTest, lightsFilesBringTheirTexturesAlong) {
    GltfBuilder builder = withLight({{"type", "rect"}, {"texture", {{"index", 0}}}});
    addTexture(builder);
    // An image of no light is not asked for.
    builder.add("images", {{"uri", "missing.png"}});
    const Scene lights = readGltfLights(writeBytes("lights.glb", builder.glb()));
    EXPECT_TRUE(std::get<PolygonLight>(lights.areaLights.at(0).shape).texture.has_value());
}

TEST(PolylumeLightTest, aScaleOfNothingLeavesOutTheLight) {
    for (const char* type : {"rect", "ellipse", "sphere", "tube"}) {
        const WarningLog log;
        EXPECT_THAT(withLight({{"type", type}}, {{"scale", {0, 0, 0}}}).read().areaLights,
                    IsEmpty());
        EXPECT_THAT(log.messages, ElementsAre(HasSubstr("has no extent"))) << type;
    }
    EXPECT_THAT(withLight(polygonLight(), {{"scale", {1, 0, 1}}}).read().areaLights, IsEmpty());
}

TEST(PolylumeLightTest, extrasAndExtensionsArePassedOver) {
    const WarningLog log;
    EXPECT_THAT(withLight({{"type", "sphere"},
                           {"extras", {{"any", 1}}},
                           {"extensions", {{"ANY_thing", json::object()}}},
                           {"sphere", {{"extras", 1}}}})
                    .read()
                    .areaLights,
                SizeIs(1));
    EXPECT_THAT(log.messages, IsEmpty());
}

}  // namespace
}  // namespace polylume::scene::test
