// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lighting_pass.hpp"

#include <gmock/gmock.h>

#include <map>
#include <random>

#include "gl/support/gl_test.hpp"
#include "ltc/builtin_table.hpp"
#include "shading_harness.hpp"

namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize =
    128;  // The harness's points lie within 1 of the axis, 0 to 16 in front of the camera.

/// A concave outline with a hole, facing the points: in the plane z = `z`, emitting toward -z.
PolygonLight makeConcaveLight(float z) {
    PolygonLight light;
    // An L and a square hole in its corner. Counter-clockwise seen from -z is clockwise seen from
    // +z.
    light.contours = {
        {{-1, -1, z}, {-1, 2, z}, {0.2f, 2, z}, {0.2f, 0.6f, z}, {1.5f, 0.6f, z}, {1.5f, -1, z}},
        {{-0.7f, -0.6f, z}, {-0.1f, -0.6f, z}, {-0.1f, 0.1f, z}, {-0.7f, 0.1f, z}}};
    light.radiance = glm::vec3(1.0f);
    return light;
}

PolygonLight makeRectangle(const glm::vec3& corner, const glm::vec3& x, const glm::vec3& y) {
    PolygonLight light;
    light.contours = {{corner, corner + x, corner + x + y, corner + y}};
    light.radiance = glm::vec3(1.0f);
    return light;
}

/// Normals tilted every way around the direction to the camera and, with some, to its back.
std::vector<ShadingPoint> makePoints(int count, float roughness, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
    for (ShadingPoint& point : points) {
        point.normalWorld = glm::normalize(
            glm::vec3(uniform(generator), uniform(generator), 0.6f + 0.5f * uniform(generator)));
        point.distance = 4.0f + uniform(generator);
        point.roughness = roughness;
    }
    return points;
}

class LightingPassTest : public test::GlTest {
  protected:
    /// The largest difference to double precision over all points, as a fraction of the largest
    /// value.
    double largestError(const PolygonLight& light, float roughness, Lobes lobes,
                        const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx)) {
        const gl::ShaderLibrary library;
        LightingPass lighting(gl(), library, table);
        lighting.setLobes(lobes);
        lighting.setLights({{light}, {}});
        ShadingHarness harness(gl(), kSize);
        std::vector<ShadingPoint> points = makePoints(harness.pointCount(), roughness, 7);
        test::reflectOnly(lobes, points);
        harness.setPoints(points);
        const std::vector<glm::vec4> shaded = harness.shade(lighting);
        const std::vector<SurfacePixel> decoded = harness.decoded();
        double largest = 0.0;
        double error = 0.0;
        for (std::size_t i = 0; i < shaded.size(); ++i) {
            const test::ReferenceShading reference = test::shadeInDouble(decoded[i], light, table);
            const double expected =
                lobes == Lobes::diffuse ? reference.diffuse : reference.albedo * reference.specular;
            largest = std::max(largest, expected);
            error = std::max(error, std::abs(shaded[i].x - expected));
        }
        EXPECT_GT(largest, 0.02);
        return error / largest;
    }
};

const glm::vec3 kRight(1, 0, 0);
const glm::vec3 kUp(0, 1, 0);

TEST_P(LightingPassTest, diffuseEqualsDoublePrecision) {
    // Float's rounding of positions and of the sum; a light that covers a tenth of the hemisphere
    // leaves 1e-6.
    EXPECT_LT(
        largestError(makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight), 0.5f, Lobes::diffuse),
        5e-6);
    EXPECT_LT(largestError(makeConcaveLight(0.0f), 0.5f, Lobes::diffuse), 5e-6);
}

TEST_P(LightingPassTest, specularEqualsDoublePrecision) {
    for (const float roughness : {0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        EXPECT_LT(largestError(makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight), roughness,
                               Lobes::specular),
                  1e-4)
            << roughness;
        EXPECT_LT(largestError(makeConcaveLight(0.0f), roughness, Lobes::specular), 1e-4)
            << roughness;
    }
}

TEST_P(LightingPassTest, smootherThanTheGuaranteeStaysClose) {
    // Below r = 0.05 the lobe's edge is sharper than float can place it; twice what was measured.
    const PolygonLight light = makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight);
    const double at002 = largestError(light, 0.02f, Lobes::specular);
    const double at0 = largestError(light, 0.0f, Lobes::specular);
    RecordProperty("error at r = 0.02", std::to_string(at002));
    RecordProperty("error at r = 0", std::to_string(at0));
    EXPECT_LT(at002, 1e-4);
    EXPECT_LT(at0, 2.5e-4);
}

TEST_P(LightingPassTest, lightThroughTheSurfaceIsClippedAtIt) {
    // Cuts the horizon of every point: the plane of the points' mean depth runs through its middle.
    const PolygonLight rectangle = makeRectangle({-3, -1, -6}, 3.0f * kUp, {0, 0, 4});
    EXPECT_LT(largestError(rectangle, 0.4f, Lobes::specular), 1e-4);
    EXPECT_LT(largestError(rectangle, 0.4f, Lobes::diffuse), 1e-5);
    PolygonLight star = makeConcaveLight(0.0f);
    for (auto& contour : star.contours) {
        for (glm::vec3& vertex : contour) vertex = {3.0f, vertex.y, -4.0f - vertex.x};
    }
    EXPECT_LT(largestError(star, 0.4f, Lobes::specular), 1e-4);
    EXPECT_LT(largestError(star, 0.4f, Lobes::diffuse), 1e-5);
}

TEST_P(LightingPassTest, everyPathOfAPolygonEqualsDoublePrecision) {
    // A triangle, a convex polygon, and one of sizes at which squares of squares would overflow; in
    // front of the points and through their surfaces.
    const std::vector<glm::vec3> hexagon = {{-1, 0, 0}, {-0.5f, 1, 0}, {0.5f, 1, 0},
                                            {1, 0, 0},  {0.5f, -1, 0}, {-0.5f, -1, 0}};
    const std::vector<glm::vec3> triangle = {{-1, -1, 0}, {0, 1.5f, 0}, {1, -1, 0}};
    for (const auto& contour : {triangle, hexagon}) {
        PolygonLight light;
        light.radiance = glm::vec3(1.0f);
        light.contours = {contour};
        EXPECT_LT(largestError(light, 0.4f, Lobes::diffuse), 5e-6);
        EXPECT_LT(largestError(light, 0.1f, Lobes::specular), 1e-4);
        for (glm::vec3& v : light.contours[0]) v = {3.0f, v.y, -4.0f - v.x};
        EXPECT_LT(largestError(light, 0.4f, Lobes::diffuse), 1e-5);
        EXPECT_LT(largestError(light, 0.4f, Lobes::specular), 1e-4);
        light.contours = {contour};
        for (glm::vec3& v : light.contours[0]) v = 1e12f * (v + glm::vec3(0.0f, 0.0f, 1.0f));
        EXPECT_LT(largestError(light, 0.4f, Lobes::diffuse), 5e-6);
        EXPECT_LT(largestError(light, 0.4f, Lobes::specular), 1e-4);
    }
}

TEST_P(LightingPassTest, rectangleAndItsPolygonAgree) {
    const PolygonLight rectangle = makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight);
    PolygonLight split = rectangle;
    // A vertex in the middle of an edge changes nothing but the path through the shader.
    auto& contour = split.contours.front();
    contour.insert(contour.begin() + 1, 0.5f * (contour[0] + contour[1]));
    EXPECT_EQ(packLights({{rectangle}, {}}).parallelograms.size(), 1u);
    EXPECT_EQ(packLights({{split}, {}}).polygons.size(), 1u);
    EXPECT_LT(largestError(split, 0.4f, Lobes::specular), 1e-4);
}

/// Every `columnStep`-th column and `rowStep`-th row of `table`, from the first on; a step of 0
/// takes column 40 alone.
ltc::Table thinOut(const ltc::Table& table, int columnStep, int rowStep) {
    ltc::TableSize size;
    size.columns = columnStep == 0 ? 1 : (table.size().columns - 1) / columnStep + 1;
    size.rows = (table.size().rows - 1) / rowStep + 1;
    std::vector<float> values;
    for (int row = 0; row < size.rows; ++row) {
        for (int column = 0; column < size.columns; ++column) {
            const int from = columnStep == 0 ? 40 : column * columnStep;
            const auto node = table.layout().pack(table.node(from, row * rowStep));
            values.insert(values.end(), node.begin(), node.end());
        }
    }
    return ltc::Table(size, values, table.attributes());
}

TEST_P(LightingPassTest, tablesOfOtherSizesEqualDoublePrecision) {
    const PolygonLight light = makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight);
    for (const ltc::BuiltinTable name : {ltc::BuiltinTable::ggx, ltc::BuiltinTable::ggxTwoLobes}) {
        const ltc::Table& table = ltc::builtinTable(name);
        const ltc::Table wide = thinOut(table, 3, 7);
        EXPECT_EQ(wide.size().columns, 22);
        EXPECT_EQ(wide.size().rows, 10);
        EXPECT_LT(largestError(light, 0.4f, Lobes::specular, wide), 1e-4);
        const ltc::Table single = thinOut(table, 0, 3);
        EXPECT_EQ(single.size().columns, 1);
        EXPECT_LT(largestError(light, 0.4f, Lobes::specular, single), 1e-4);
    }
}

/// A table as other renderers ship it is uploaded in our own layout.
TEST_P(LightingPassTest, classicTablesEqualDoublePrecision) {
    const ltc::Table& own = ltc::builtinTable(ltc::BuiltinTable::ggx);
    ltc::TableLayout layout;
    layout.classic = true;
    std::map<std::string, std::string> attributes = layout.attributes();
    attributes.insert(own.attributes().begin(), own.attributes().end());
    constexpr int kNodes = 32;
    std::vector<float> values;
    for (int row = 0; row < kNodes; ++row) {
        const double cosine =
            std::max(layout.cosThetaView(row / (kNodes - 1.0)), ltc::kMinCosThetaView);
        for (int column = 0; column < kNodes; ++column) {
            const ltc::TableEntry entry = own.lookup(column / (kNodes - 1.0), cosine);
            const ltc::Lobe& lobe = entry.lobes[0];
            for (const double value :
                 {lobe.m11, lobe.m13, lobe.m31, lobe.m33, entry.albedo, entry.fresnel}) {
                values.push_back(static_cast<float>(value));
            }
        }
    }
    const ltc::Table classic({kNodes, kNodes}, values, attributes);
    const PolygonLight light = makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight);
    const double error = largestError(light, 0.4f, Lobes::specular, ltc::nativeTable(classic));
    EXPECT_LT(error, 1e-4);
    // It is blended otherwise between its nodes, so its own look-up differs a little.
    EXPECT_LT(largestError(light, 0.4f, Lobes::specular, classic), 0.02);
}

TEST_P(LightingPassTest, backIsDarkUnlessTwoSided) {
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library);
    ShadingHarness harness(gl(), kSize);
    harness.setPoints(std::vector<ShadingPoint>(static_cast<std::size_t>(harness.pointCount()),
                                                ShadingPoint{.distance = 4.0f}));
    for (const bool concave : {false, true}) {
        PolygonLight light = concave ? makeConcaveLight(0.0f)
                                     : makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight);
        lighting.setLights({{light}, {}});
        const std::vector<glm::vec4> front = harness.shade(lighting);
        for (auto& contour : light.contours) std::ranges::reverse(contour);
        lighting.setLights({{light}, {}});
        const std::vector<glm::vec4> back = harness.shade(lighting);
        light.twoSided = true;
        lighting.setLights({{light}, {}});
        const std::vector<glm::vec4> both = harness.shade(lighting);
        for (std::size_t i = 0; i < front.size(); ++i) {
            ASSERT_GT(front[i].x, 0.0f);
            ASSERT_EQ(back[i].x, 0.0f);
            ASSERT_NEAR(both[i].x, front[i].x, 1e-5f);
        }
    }
}

TEST_P(LightingPassTest, lobesAddUp) {
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library);
    lighting.setLights({{makeRectangle({-1, -1, 0}, 2.0f * kUp, 3.0f * kRight)}, {}});
    ShadingHarness harness(gl(), kSize);
    harness.setPoints(makePoints(harness.pointCount(), 0.4f, 3));
    const std::vector<glm::vec4> all = harness.shade(lighting);
    lighting.setLobes(Lobes::diffuse);
    const std::vector<glm::vec4> diffuse = harness.shade(lighting);
    lighting.setLobes(Lobes::specular);
    const std::vector<glm::vec4> specular = harness.shade(lighting);
    for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_NEAR(all[i].x, diffuse[i].x + specular[i].x, 1e-6f);
}

TEST_P(LightingPassTest, smallFarLightIsAPointLight) {
    // An area light of radiance L and area A seen head-on from afar is a point light of L A
    // candela.
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library);
    ShadingHarness harness(gl(), kSize);
    std::vector<ShadingPoint> points = makePoints(harness.pointCount(), 0.9f, 5);
    for (ShadingPoint& point : points) point.f0 = glm::vec3(0.0f), point.f90 = 0.0f;
    harness.setPoints(points);
    PolygonLight area = makeRectangle({-0.05f, -0.05f, 40.0f}, 0.1f * kUp, 0.1f * kRight);
    area.radiance = glm::vec3(1e6f);
    lighting.setLights({{area}, {}});
    const std::vector<glm::vec4> byArea = harness.shade(lighting);
    PunctualLight point;
    point.position = {0, 0, 40};
    point.intensity = glm::vec3(1e6f * 0.01f);
    lighting.setLights({{}, {point}});
    const std::vector<glm::vec4> byPoint = harness.shade(lighting);
    for (std::size_t i = 0; i < byArea.size(); ++i) {
        // The light is not quite head-on from the side points: cos of up to 2 degrees; and float
        // cancels at 1/450.
        ASSERT_NEAR(byArea[i].x, byPoint[i].x, 3e-3f * byPoint[i].x + 1e-3f) << i;
    }
}

POLYLUME_ON_EVERY_BACKEND(LightingPassTest);

}  // namespace
}  // namespace polylume
