// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_packing.hpp"

#include <gmock/gmock.h>

#include <bit>

#include "polylume/error.hpp"

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
    trapezium.contours[0][2] = {1.5f, 2, 0};
    PolygonLight triangle = makeSquare();
    triangle.contours[0].pop_back();
    PolygonLight holed = makeSquare();
    holed.contours.push_back({{0.5f, 0.5f, 0}, {0.5f, 1, 0}, {1, 1, 0}});
    const PackedLights packed = packLights({{trapezium, triangle, holed}, {}});
    EXPECT_EQ(packed.parallelograms.size(), 0u);
    ASSERT_EQ(packed.polygons.size(), 3u);
    // Triangles come first. Each contour begins with its number of edges and ends with its first
    // vertex again.
    EXPECT_EQ(packed.triangleCount, 1u);
    EXPECT_EQ(packed.polygons[0].vertices.x, 0u);
    EXPECT_EQ(packed.polygons[0].vertices.y, 4u);
    EXPECT_EQ(packed.polygonVertices[0].w, 3.0f);
    EXPECT_EQ(packed.polygonVertices[3], glm::vec4(0, 0, 0, 0));
    EXPECT_EQ(packed.polygons[1].vertices.x, 4u);
    EXPECT_EQ(packed.polygons[1].vertices.y, 5u);
    EXPECT_EQ(std::bit_cast<float>(packed.polygons[1].vertices.z), 2.5f);
    EXPECT_EQ(packed.polygons[2].vertices.y, 9u);
    EXPECT_EQ(packed.polygonVertices[14].w, 3.0f);
}

TEST(LightPackingTest, lightWithoutAreaIsLeftOut) {
    PolygonLight line = makeSquare();
    for (glm::vec3& vertex : line.contours[0]) vertex.y = 0.0f;
    const PackedLights packed = packLights({{line, makeSquare()}, {}});
    EXPECT_EQ(packed.parallelograms.size() + packed.polygons.size(), 1u);
}

TEST(LightPackingTest, roundLightsKeepTheirShape) {
    EllipseLight ellipse;
    ellipse.center = {1, 2, 3};
    ellipse.halfAxisX = {0, 3, 0};
    ellipse.halfAxisY = {0, 0, 2};
    ellipse.twoSided = true;
    SphereLight sphere;
    sphere.center = {4, 5, 6};
    sphere.radius = 0.25f;
    TubeLight tube;
    tube.start = {1, 1, 1};
    tube.end = {2, 4, 3};
    tube.twoSided = true;
    const PackedLights packed = packLights({{}, {}, {ellipse}, {sphere}, {tube}});
    EXPECT_EQ(packed.polygons.size() + packed.parallelograms.size(), 0u);
    ASSERT_EQ(packed.ellipses.size(), 1u);
    EXPECT_EQ(packed.ellipses[0].center, glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(packed.ellipses[0].halfAxisX, glm::vec4(0, 3, 0, 0));
    EXPECT_EQ(packed.ellipses[0].halfAxisY, glm::vec4(0, 0, 2, 0));
    EXPECT_EQ(packed.ellipses[0].normal, glm::vec4(1, 0, 0, 0));
    ASSERT_EQ(packed.spheres.size(), 1u);
    EXPECT_EQ(packed.spheres[0].center, glm::vec4(4, 5, 6, 0.25f));
    EXPECT_EQ(packed.spheres[0].radiance.w, 0.0f);
    ASSERT_EQ(packed.tubes.size(), 1u);
    EXPECT_EQ(packed.tubes[0].start, glm::vec4(1, 1, 1, tube.radius));
    EXPECT_EQ(packed.tubes[0].axis, glm::vec4(1, 3, 2, 0));
    EXPECT_EQ(packed.tubes[0].radiance.w, 1.0f);
}

TEST(LightPackingTest, disksComeBeforeOtherEllipses) {
    EllipseLight ellipse;
    ellipse.halfAxisX = {0, 3, 0};
    ellipse.halfAxisY = {0, 0, 3.001f};
    EllipseLight disk;
    // Equal but for rounding.
    disk.halfAxisX = {0.3f, 0.4f, 0};
    disk.halfAxisY = {0, 0, 0.5f};
    const PackedLights packed = packLights({{}, {}, {ellipse, disk}});
    ASSERT_EQ(packed.ellipses.size(), 2u);
    EXPECT_EQ(packed.diskCount, 1u);
    EXPECT_EQ(packed.ellipses[0].halfAxisY.z, 0.5f);
}

TEST(LightPackingTest, roundLightOfNoSizeIsLeftOut) {
    EllipseLight line;
    line.halfAxisY = line.halfAxisX;
    SphereLight dot;
    dot.radius = 0.0f;
    TubeLight thread;
    thread.radius = 0.0f;
    const PackedLights packed = packLights({{}, {}, {line}, {dot}, {thread}});
    EXPECT_EQ(packed.ellipses.size() + packed.spheres.size() + packed.tubes.size(), 0u);
}

TEST(LightPackingTest, tubeOfNoLengthIsKept) {
    TubeLight tube;
    tube.end = tube.start;
    EXPECT_EQ(packLights({{}, {}, {}, {}, {tube}}).tubes.size(), 1u);
}

TEST(LightPackingTest, badLightsAreRefused) {
    EXPECT_THROW(packLights({{PolygonLight{}}, {}}), Error);
}

}  // namespace
}  // namespace polylume
