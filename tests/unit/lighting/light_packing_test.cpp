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
    line.halfAxisY = glm::vec3(0.0f);
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

/// A triangle, a square, a line, an L and a second triangle, each of a radiance of its own.
LightSet makeMixedPolygons() {
    LightSet lights;
    PolygonLight triangle = makeSquare();
    triangle.contours[0].pop_back();
    PolygonLight line = makeSquare();
    for (glm::vec3& vertex : line.contours[0]) vertex.y = 0.0f;
    PolygonLight corner = makeSquare();
    corner.contours[0].insert(corner.contours[0].begin() + 3, {1, 2, 0});
    corner.contours[0][2] = {1, 1, 0};
    lights.polygons = {triangle, makeSquare(), line, corner, triangle};
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        lights.polygons[i].radiance = glm::vec3(static_cast<float>(i));
    }
    return lights;
}

TEST(LightPackingTest, placesLeadToEachLight) {
    const PackedLights packed = packLights(makeMixedPolygons());
    const std::vector<LightPlace>& places = packed.places.polygons;
    ASSERT_EQ(places.size(), 5u);
    EXPECT_EQ(places[0].kind, LightKind::triangle);
    EXPECT_EQ(packed.polygons[places[0].slot].radiance.x, 0.0f);
    EXPECT_EQ(places[1].kind, LightKind::parallelogram);
    EXPECT_EQ(packed.parallelograms[places[1].slot].radiance.x, 1.0f);
    EXPECT_EQ(places[2].kind, LightKind::none);
    EXPECT_EQ(places[3].kind, LightKind::polygon);
    EXPECT_EQ(packed.polygons[places[3].slot].radiance.x, 3.0f);
    EXPECT_EQ(places[4].kind, LightKind::triangle);
    EXPECT_EQ(packed.polygons[places[4].slot].radiance.x, 4.0f);
}

TEST(LightPackingTest, aLightIsPackedOverAnother) {
    LightSet lights = makeMixedPolygons();
    PackedLights packed = packLights(lights);
    for (PolygonLight& light : lights.polygons) {
        for (glm::vec3& vertex : light.contours[0]) vertex = {vertex.y, 3.0f, 2.0f * vertex.x};
        light.radiance *= 2.0f;
        light.twoSided = true;
    }
    const PackedLights wanted = packLights(lights);
    for (std::size_t i = 0; i < lights.polygons.size(); ++i) {
        packLight(lights.polygons[i], packed.places.polygons[i], packed);
    }
    EXPECT_EQ(packed.polygonVertices, wanted.polygonVertices);
    for (std::size_t i = 0; i < wanted.polygons.size(); ++i) {
        EXPECT_EQ(packed.polygons[i].vertices, wanted.polygons[i].vertices);
        EXPECT_EQ(packed.polygons[i].plane, wanted.polygons[i].plane);
        EXPECT_EQ(packed.polygons[i].radiance, wanted.polygons[i].radiance);
    }
    EXPECT_EQ(packed.parallelograms[0].corner, wanted.parallelograms[0].corner);
    EXPECT_EQ(packed.parallelograms[0].edgeY, wanted.parallelograms[0].edgeY);
    EXPECT_EQ(packed.parallelograms[0].normal, wanted.parallelograms[0].normal);
}

TEST(LightPackingTest, farLightsScaleAllDown) {
    LightSet lights = makeMixedPolygons();
    PackedLights packed = packLights(lights);
    EXPECT_EQ(packed.flatScale, 1.0f);
    packLight(makeSquare({4e9f, 0, 0}), packed.places.polygons[1], packed);
    EXPECT_FLOAT_EQ(packed.flatScale, 0.25f);
    packLight(makeSquare(), packed.places.polygons[1], packed);
    EXPECT_FLOAT_EQ(packed.flatScale, 0.25f) << "it only falls";
}

/// An image upright on the square or on half of it.
PolygonLight makeFilm(bool isParallelogram) {
    PolygonLight light = makeSquare();
    if (!isParallelogram) light.contours[0].pop_back();
    auto image = std::make_shared<LightImage>();
    image->size = {2, 2};
    image->texels.assign(4, glm::vec3(1.0f));
    light.texture = LightTexture{image, {0, 2, 0}, {2, 0, 0}, {0, -2, 0}};
    return light;
}

TEST(LightTextureFrameTest, aFrameMovesWithItsLight) {
    for (const bool isParallelogram : {true, false}) {
        const PolygonLight light = makeFilm(isParallelogram);
        const LightTextureFrame frame = lightTextureFrame(light, isParallelogram);
        const auto moved = [&](const PolygonLight& other) {
            return movedFrame(other, isParallelogram, frame, *light.texture);
        };
        // By a turn about x and a step.
        PolygonLight turned = light;
        const auto turn = [](const glm::vec3& v) { return glm::vec3(v.x, -v.z, v.y); };
        const glm::vec3 step(1000.25f, 0.0f, -7.0f);
        for (glm::vec3& vertex : turned.contours[0]) vertex = turn(vertex) + step;
        turned.texture->origin = turn(turned.texture->origin) + step;
        turned.texture->axisU = turn(turned.texture->axisU);
        turned.texture->axisV = turn(turned.texture->axisV);
        turned.texture->image = nullptr;
        const auto edges = moved(turned);
        ASSERT_TRUE(edges.has_value());
        EXPECT_LT(glm::distance(edges->corner, glm::dvec3(turn(frame.corner) + step)), 1e-3);
        EXPECT_LT(glm::distance(edges->edgeX, glm::dvec3(turn(frame.edgeX))), 1e-3);
        EXPECT_LT(glm::distance(edges->edgeY, glm::dvec3(turn(frame.edgeY))), 1e-3);

        const auto changes = [&](const auto& change) {
            PolygonLight other = light;
            change(other);
            return !moved(other).has_value();
        };
        EXPECT_FALSE(changes([](PolygonLight&) {}));
        EXPECT_TRUE(changes([](PolygonLight& l) { l.texture->origin.x += 0.01f; }));
        EXPECT_TRUE(changes([](PolygonLight& l) { l.texture->axisU *= 1.01f; }));
        EXPECT_TRUE(changes([](PolygonLight& l) { l.texture->wrapV = TextureWrap::repeat; }));
        EXPECT_TRUE(changes([](PolygonLight& l) {
            for (glm::vec3& vertex : l.contours[0]) vertex *= 0.9f;
        }));
    }
}

TEST(LightPackingTest, badLightsAreRefused) {
    EXPECT_THROW(packLights({{PolygonLight{}}, {}}), Error);
}

}  // namespace
}  // namespace polylume
