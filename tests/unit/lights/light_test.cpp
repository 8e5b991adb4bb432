// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/light.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "lights/light_outline.hpp"
#include "support/error_of.hpp"

namespace polylume {
namespace {

PolygonLight makeSquare() {
    PolygonLight light;
    light.contours = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}};
    return light;
}

std::string errorOf(const LightSet& lights) {
    return test::errorOf([&] { checkLights(lights); });
}

TEST(LightTest, areaVectorPointsToTheSideThatSeesTheContourTurnCounterClockwise) {
    std::vector<glm::vec3> contour = makeSquare().contours.front();
    EXPECT_EQ(areaVector(contour), glm::dvec3(0, 0, 8));
    std::ranges::reverse(contour);
    EXPECT_EQ(areaVector(contour), glm::dvec3(0, 0, -8));
}

TEST(LightTest, outlineOfAnEllipseHasItsArea) {
    EllipseLight light;
    light.center = {5, 5, 5};
    light.halfAxisX = {1.5f, 0, 0};
    light.halfAxisY = {0, -1, 0};
    for (const int sides : {3, 64}) {
        const std::vector<glm::vec3> contour = outline(light, sides);
        EXPECT_EQ(contour.size(), static_cast<std::size_t>(sides));
        // Toward cross(halfAxisX, halfAxisY), whatever the number of sides.
        EXPECT_NEAR(0.5 * areaVector(contour).z, -1.5 * std::numbers::pi, 1e-5);
    }
}

TEST(LightTest, badLightsAreNamed) {
    PolygonLight dark = makeSquare();
    dark.radiance.y = -1.0f;
    EXPECT_THAT(errorOf({{makeSquare(), dark}, {}}),
                ::testing::HasSubstr("radiance of polygon light 1"));
    PolygonLight infinite = makeSquare();
    infinite.contours[0][3].z = std::numeric_limits<float>::infinity();
    EXPECT_THAT(errorOf({{infinite}, {}}),
                ::testing::HasSubstr("finite vertices in polygon light 0"));
    PolygonLight flat = makeSquare();
    flat.contours[0].resize(2);
    EXPECT_THAT(errorOf({{flat}, {}}), ::testing::HasSubstr("3 vertices or more, found 2"));
    EXPECT_THAT(errorOf({{PolygonLight{}}, {}}), ::testing::HasSubstr("found none"));
    EllipseLight nowhere;
    nowhere.center.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(errorOf({{}, {}, {nowhere}}), ::testing::HasSubstr("ellipse light 0"));
    PunctualLight nan;
    nan.intensity.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(errorOf({{}, {nan}}), ::testing::HasSubstr("intensity of punctual light 0"));
}

}  // namespace
}  // namespace polylume
