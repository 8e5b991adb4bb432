// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lights/texture_check.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "support/error_of.hpp"

namespace polylume {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

LightImage makeImage() {
    return {{2, 3}, std::vector<glm::vec3>(6, glm::vec3(0.5f))};
}

/// A square in the plane z = 0 with the image over all of it.
PolygonLight makeLight(const LightImage& image = makeImage()) {
    PolygonLight light;
    light.contours = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
    light.texture =
        LightTexture{std::make_shared<const LightImage>(image), {0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    return light;
}

/// Of checkLights(), as what draws and what traces the lights hear it: of the second polygon.
std::string errorOf(const PolygonLight& light) {
    PolygonLight plain = makeLight();
    plain.texture.reset();
    return test::errorOf([&] { checkLights({{plain, light}, {}}); });
}

TEST(TextureCheck, goodTexturesPass) {
    PolygonLight light = makeLight();
    EXPECT_NO_THROW(checkLights({{light}, {}}));
    // At an angle, mirrored, a thousandth off the plane, with its origin anywhere.
    light.texture->origin = {-7, 3, 2};
    light.texture->axisU = {0.001f, -3, 0.002f};
    light.texture->axisV = {4, 0.5f, 0};
    EXPECT_NO_THROW(checkLights({{light}, {}}));
    light.texture.reset();
    EXPECT_NO_THROW(checkLights({{light}, {}}));
}

TEST(TextureCheck, imagesThatAreNoneAreNamed) {
    PolygonLight light = makeLight();
    light.texture->image.reset();
    EXPECT_THAT(errorOf(light), HasSubstr("texture of polygon light 1 to have an image"));
    LightImage image = makeImage();
    image.texels.pop_back();
    EXPECT_THAT(
        errorOf(makeLight(image)),
        AllOf(HasSubstr("6 texels in the texture of polygon light 1"), HasSubstr("2x3, found 5")));
    image = makeImage();
    image.size = {-2, -3};
    EXPECT_THAT(errorOf(makeLight(image)), HasSubstr("found -2x-3"));
    image = {};
    EXPECT_THAT(errorOf(makeLight(image)), HasSubstr("found 0x0"));
}

TEST(TextureCheck, texelsThatAreNoLightAreNamed) {
    for (const float value :
         {-0.001f, -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity(),
          std::numeric_limits<float>::quiet_NaN()}) {
        LightImage image = makeImage();
        image.texels[3].y = value;
        EXPECT_THAT(errorOf(makeLight(image)),
                    AllOf(HasSubstr("finite texels from 0 in the texture of polygon light 1"),
                          HasSubstr("column 1, row 1")));
        EXPECT_THAT(test::errorOf([&] { checkLightImage(image, 7); }),
                    HasSubstr("polygon light 7"));
    }
}

TEST(TextureCheck, axesThatSpanNoPlaneOfTheLightAreNamed) {
    const auto withAxes = [](const glm::vec3& u, const glm::vec3& v) {
        PolygonLight light = makeLight();
        light.texture->axisU = u;
        light.texture->axisV = v;
        return errorOf(light);
    };
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(withAxes({0, 0, 0}, {0, 1, 0}), HasSubstr("span a plane, found (0, 0, 0)"));
    EXPECT_THAT(withAxes({1, 2, 0}, {-2, -4, 0}), HasSubstr("span a plane"));
    EXPECT_THAT(withAxes({1, 0, 0}, {1, 1e-4f, 0}), HasSubstr("polygon light 1 to span a plane"));
    EXPECT_THAT(withAxes({1, 0, 0}, {0, kNan, 0}), HasSubstr("finite axes"));
    EXPECT_THAT(withAxes({1, 0, 0}, {0, 1, 1}), HasSubstr("axisV of the texture"));
    EXPECT_THAT(withAxes({1, 0, 0.1f}, {0, 1, 0}), HasSubstr("to lie in the light's plane"));
    PolygonLight nowhere = makeLight();
    nowhere.texture->origin.z = std::numeric_limits<float>::infinity();
    EXPECT_THAT(errorOf(nowhere), HasSubstr("finite origin"));
}

}  // namespace
}  // namespace polylume
