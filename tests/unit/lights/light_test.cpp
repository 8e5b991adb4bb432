// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/light.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <numbers>
#include <utility>

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

TEST(LightTest, anyMemberMayBeLeftOutOfAnInitialiser) {
    // As hosts write it; -Wextra, an error in tests, would complain of members without a default.
    const LightImage image{.size = {1, 1}};
    const LightTexture texture{.origin = {1, 2, 3}};
    const LightSet lights{.polygons = {{.radiance = glm::vec3(1.0f), .texture = texture}},
                          .tubes = {{.radius = 0.5f}}};
    EXPECT_TRUE(image.texels.empty());
    EXPECT_TRUE(lights.polygons[0].contours.empty());
    EXPECT_TRUE(lights.punctuals.empty());
}

TEST(LightTest, halfAxesAreAtRightAngles) {
    EllipseLight light;
    const auto message = [&] { return errorOf({{}, {}, {light}}); };
    light.halfAxisX = {3.0f, 0.0f, 0.0f};
    light.halfAxisY = {0.0005f, 1.0f, 0.0f};
    EXPECT_EQ(message(), "no error");
    light.halfAxisY = {0.002f, 1.0f, 0.0f};
    EXPECT_THAT(message(), ::testing::HasSubstr("half axes of ellipse light 0 to be at right"));
    light.halfAxisX = light.halfAxisY = glm::vec3(0.0f);
    EXPECT_EQ(message(), "no error");
}

TEST(LightTest, punctualLightsAreAsDocumented) {
    const auto messageOf = [](PunctualLightKind kind, const auto& spoil) {
        PunctualLight light;
        light.kind = kind;
        spoil(light);
        return errorOf({{}, {light}});
    };
    using Kind = PunctualLightKind;
    using ::testing::HasSubstr;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Kind kind : {Kind::directional, Kind::point, Kind::spot}) {
        EXPECT_EQ(messageOf(kind, [](PunctualLight&) {}), "no error");
        for (const float range : {0.0f, -1.0f, nan}) {
            EXPECT_THAT(messageOf(kind, [&](PunctualLight& l) { l.range = range; }),
                        HasSubstr("range of punctual light 0 to be above 0"));
        }
    }
    for (const Kind kind : {Kind::directional, Kind::spot}) {
        for (const float length : {0.0f, 0.99f, 1.01f, 2.0f}) {
            EXPECT_THAT(messageOf(kind, [&](PunctualLight& l) { l.direction *= length; }),
                        HasSubstr("direction of punctual light 0 to be of length 1"));
        }
        EXPECT_EQ(messageOf(kind, [](PunctualLight& l) { l.direction *= 1.0005f; }), "no error");
    }
    EXPECT_EQ(messageOf(Kind::point, [](PunctualLight& l) { l.direction *= 0.0f; }), "no error");
    const auto cone = [&](float inner, float outer) {
        return messageOf(Kind::spot, [&](PunctualLight& l) {
            l.innerConeAngle = inner;
            l.outerConeAngle = outer;
        });
    };
    EXPECT_EQ(cone(0.0f, std::numbers::pi_v<float> / 2.0f), "no error");
    EXPECT_EQ(cone(0.5f, 0.5f), "no error");
    for (const auto& [inner, outer] : {std::pair{0.6f, 0.5f},
                                       {-0.1f, 0.5f},
                                       {0.0f, 1.6f},
                                       {0.0f, 45.0f},
                                       {nan, 0.5f},
                                       {0.0f, nan}}) {
        EXPECT_THAT(cone(inner, outer), HasSubstr("innerConeAngle <= outerConeAngle"));
    }
}

}  // namespace
}  // namespace polylume
