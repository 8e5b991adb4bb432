// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace polylume {
namespace {

PolygonLight makeSquare(const glm::vec3& offset = glm::vec3(0.0f)) {
    PolygonLight light;
    light.contours = {{offset, offset + glm::vec3(2, 0, 0), offset + glm::vec3(2, 2, 0),
                       offset + glm::vec3(0, 2, 0)}};
    return light;
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

TEST(LightPackingTest, ellipseBecomesAPolygon) {
    const PackedLights packed = packLights({{}, {}, {EllipseLight{}}});
    ASSERT_EQ(packed.polygons.size(), 1u);
    EXPECT_EQ(packed.polygons[0].vertices.y, 65u);
    EXPECT_EQ(packed.polygons[0].plane, glm::vec4(0, 0, 1, 0));
}

TEST(LightPackingTest, badLightsAreRefused) {
    EXPECT_THROW(packLights({{PolygonLight{}}, {}}), Error);
}

}  // namespace
}  // namespace polylume
