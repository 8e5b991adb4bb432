// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "core/error.hpp"

namespace polylume {
namespace {

PolygonLight makeSquare(const glm::vec3& offset = glm::vec3(0.0f)) {
    PolygonLight light;
    light.contours = {{offset, offset + glm::vec3(2, 0, 0), offset + glm::vec3(2, 2, 0),
                       offset + glm::vec3(0, 2, 0)}};
    return light;
}

std::string errorOf(const LightSet& lights) {
    try {
        packLights(lights);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(LightPackingTest, squareIsAParallelogram) {
    const PackedLights packed = packLights({{makeSquare({1000.3f, 7.7f, -3.1f})}, {}});
    ASSERT_EQ(packed.parallelograms.size(), 1u);
    EXPECT_EQ(packed.polygons.size(), 0u);
    EXPECT_EQ(glm::vec3(packed.parallelograms[0].normal), glm::vec3(0, 0, 1));
}

TEST(LightPackingTest, otherOutlinesArePolygons) {
    PolygonLight trapezium = makeSquare();
    trapezium.contours[0][2].x = 1.5f;
    PolygonLight triangle = makeSquare();
    triangle.contours[0].pop_back();
    PolygonLight holed = makeSquare();
    holed.contours.push_back({{0.5f, 0.5f, 0}, {0.5f, 1, 0}, {1, 1, 0}});
    const PackedLights packed = packLights({{trapezium, triangle, holed}, {}});
    EXPECT_EQ(packed.parallelograms.size(), 0u);
    ASSERT_EQ(packed.polygons.size(), 3u);
    // Each contour ends with its first vertex again.
    EXPECT_EQ(packed.polygons[1].vertices.x, 5u);
    EXPECT_EQ(packed.polygons[1].vertices.y, 4u);
    EXPECT_EQ(packed.polygonVertices[5].w, 1.0f);
    EXPECT_EQ(packed.polygonVertices[8], glm::vec4(0, 0, 0, 0));
}

TEST(LightPackingTest, lightWithoutAreaIsLeftOut) {
    PolygonLight line = makeSquare();
    for (glm::vec3& vertex : line.contours[0]) vertex.y = 0.0f;
    const PackedLights packed = packLights({{line, makeSquare()}, {}});
    EXPECT_EQ(packed.parallelograms.size() + packed.polygons.size(), 1u);
}

TEST(LightPackingTest, badLightsAreNamed) {
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
    PunctualLight nan;
    nan.intensity.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(errorOf({{}, {nan}}), ::testing::HasSubstr("intensity of punctual light 0"));
}

}  // namespace
}  // namespace polylume
