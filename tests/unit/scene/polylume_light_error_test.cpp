// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <string>

#include "unit/scene/polylume_light_files.hpp"

namespace polylume::scene::test {
namespace {

using testing::HasSubstr;

/// A light that is refused, and what the message holds beside its name and place.
struct Refused {
    const char* name;
    std::function<void(json& light)> change;
    const char* message;
};

class RefusedLightTest : public testing::TestWithParam<Refused> {};

json parse(const char* text) {
    return json::parse(text);
}

const Refused kRefused[] = {
    {"noType", [](json& l) { l.erase("type"); }, "expected \"type\", which is missing"},
    {"unknownType", [](json& l) { l["type"] = "disk"; }, "\"tube\", found \"disk\""},
    {"unknownField", [](json& l) { l["colour"] = 1; }, "expected only"},
    {"name", [](json& l) { l["name"] = 7; }, "expected \"name\" to be a string"},
    {"shortColor",
     [](json& l) {
         l["color"] = {1, 1};
     },
     "\"color\" to be an array of 3"},
    {"negativeColor",
     [](json& l) {
         l["color"] = {1, -0.1, 1};
     },
     "\"color[1]\" to be at least 0"},
    {"intensity", [](json& l) { l["intensity"] = -1; }, "\"intensity\" to be at least 0"},
    {"tooBright", [](json& l) { l["intensity"] = 1e31; }, "times \"intensity\""},
    {"twoSided", [](json& l) { l["twoSided"] = 1; }, "\"twoSided\" to be true or false"},
    {"noContours", [](json& l) { l["polygon"].erase("contours"); },
     "\"contours\", which is missing"},
    {"noPolygon", [](json& l) { l.erase("polygon"); }, "expected \"polygon\" with \"contours\""},
    {"emptyContours", [](json& l) { l["polygon"]["contours"] = json::array(); },
     "\"contours\" to be an array of one contour or more"},
    {"twoVertices", [](json& l) { l["polygon"]["contours"][0] = parse("[[0,0,0],[1,0,0]]"); },
     "\"contours[0]\" to be an array of three vertices or more"},
    {"flatVertex",
     [](json& l) {
         l["polygon"]["contours"][0][1] = {1, 2};
     },
     "\"contours[0][1]\" to be an array of 3"},
    {"wordVertex", [](json& l) { l["polygon"]["contours"][0][1][2] = "a"; },
     "\"contours[0][1]\" to be a number"},
    {"holeTurnsAlike",
     [](json& l) {
         l.erase("texture");
         l["polygon"].erase("texCoords");
         l["polygon"]["contours"].push_back(parse("[[0,0,0],[0,0.5,0],[0.5,0,0]]"));
     },
     "contours[1] to be a hole"},
    {"texCoordLengths", [](json& l) { l["polygon"]["texCoords"][0].erase(3); },
     "contours of 4 elements, as \"contours\" are, found contours of 3"},
    {"bentTexCoords",
     [](json& l) {
         l["polygon"]["texCoords"][0][0] = {0.9, 1};
     },
     "\"texCoords\" that are affine"},
    {"thinTexCoords",
     [](json& l) { l["polygon"]["texCoords"] = parse("[[[1,1], [1,1], [0,0], [0,0]]]"); },
     "\"texCoords\" that span an area"},
    {"noTexCoords", [](json& l) { l["polygon"].erase("texCoords"); },
     "\"texCoords\" beside a \"texture\""},
    {"noTexture", [](json& l) { l["texture"] = json::object(); },
     "either \"index\" or \"uri\", found neither"},
    {"twoTextures", [](json& l) { l["texture"]["uri"] = "a.png"; },
     "either \"index\" or \"uri\", found both"},
    {"textureIndex", [](json& l) { l["texture"]["index"] = 5; }, "\"index\" below 1"},
    {"textureField", [](json& l) { l["texture"]["wrap"] = 5; }, "expected only \"index\""},
    {"missingFile",
     [](json& l) {
         l["texture"] = {{"uri", "missing.exr"}};
     },
     "missing.exr"},
    {"notAnImage",
     [](json& l) {
         l["texture"] = {{"uri", "data:,hello"}};
     },
     ", texture"},
    {"partOfAnotherType",
     [](json& l) {
         l["sphere"] = {{"radius", 1}};
     },
     "no \"sphere\" in a light of type \"polygon\""},
    {"textureOnTube",
     [](json& l) {
         l["type"] = "tube";
         l.erase("polygon");
     },
     "no \"texture\" on a light of type \"tube\""},
    {"sphereRadius",
     [](json& l) {
         l = {{"name", "sign"}, {"type", "sphere"}, {"sphere", {{"radius", 0}}}};
     },
     "\"radius\" to be above 0"},
    {"tubeLength",
     [](json& l) {
         l = {{"name", "sign"}, {"type", "tube"}, {"tube", {{"length", -1}}}};
     },
     "\"length\" to be at least 0"},
    {"rectWidth",
     [](json& l) {
         l = {{"name", "sign"}, {"type", "rect"}, {"rect", {{"width", "a"}}}};
     },
     "\"width\" to be a number"},
    {"rectField",
     [](json& l) {
         l = {{"name", "sign"}, {"type", "rect"}, {"rect", {{"aspect", 1}}}};
     },
     "expected only \"width\", \"height\""},
    {"notPlanar", [](json& l) { l["polygon"]["contours"][0][2][2] = 0.5; }, "to be flat within"},
};

TEST_P(RefusedLightTest, isNamedWithItsPlace) {
    json light = polygonLight();
    light["polygon"]["texCoords"] = kSquareTexCoords;
    light["texture"] = {{"index", 0}};
    GltfBuilder builder = withLight(light);
    addTexture(builder);
    EXPECT_EQ(readError(builder), "");
    GetParam().change(builder.document["extensions"]["POLYLUME_lights_area"]["lights"][0]);
    const std::string error = readError(builder);
    EXPECT_THAT(error, HasSubstr(GetParam().message));
    EXPECT_THAT(error, HasSubstr("scene.gltf: POLYLUME_lights_area.lights[0]"));
    if (std::strcmp(GetParam().name, "name") != 0) {
        EXPECT_THAT(error, HasSubstr("\"sign\""));
    }
}

INSTANTIATE_TEST_SUITE_P(EveryField, RefusedLightTest, testing::ValuesIn(kRefused),
                         [](const auto& refused) { return std::string(refused.param.name); });

TEST(PolylumeLightTest, refusesNodesThatPointNowhere) {
    GltfBuilder builder = withLight({{"type", "sphere"}});
    builder.document["nodes"][0]["extensions"]["POLYLUME_lights_area"]["light"] = 1;
    EXPECT_THAT(readError(builder), HasSubstr("expected \"light\" below 1, found 1"));
    builder.document["nodes"][0]["extensions"]["POLYLUME_lights_area"] = json::object();
    EXPECT_THAT(readError(builder), HasSubstr("expected \"light\", which is missing"));
}

}  // namespace
}  // namespace polylume::scene::test
