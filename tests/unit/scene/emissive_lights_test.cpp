// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/emissive_lights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "core/log.hpp"
#include "lights/light_image_sampling.hpp"
#include "lights/light_outline.hpp"
#include "polylume/light.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class InfoLog {
  public:
    InfoLog() {
        setLogSink([this](LogLevel level, std::string_view message) {
            (level == LogLevel::warning ? warnings : lines).emplace_back(message);
        });
    }
    ~InfoLog() { setLogSink({}); }
    InfoLog(const InfoLog&) = delete;
    InfoLog& operator=(const InfoLog&) = delete;

    std::vector<std::string> lines, warnings;
};

/// A grid of columns x rows cells over the unit square, each cell of two triangles; `place` bends
/// it, `keep` leaves out cells. No vertex is shared: the reader has to find out.
Mesh makeGrid(
    int columns, int rows,
    const std::function<glm::vec3(float, float)>& place =
        [](float x, float y) { return glm::vec3(x, y, 0.0f); },
    const std::function<bool(int, int)>& keep = [](int, int) { return true; }) {
    Mesh mesh;
    mesh.name = "panel";
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            if (!keep(i, j)) continue;
            const std::array<glm::ivec2, 6> cell{glm::ivec2{i, j}, {i + 1, j},     {i + 1, j + 1},
                                                 {i, j},           {i + 1, j + 1}, {i, j + 1}};
            for (const glm::ivec2& corner : cell) {
                const glm::vec2 p = glm::vec2(corner) / glm::vec2(columns, rows);
                mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
                mesh.positions.push_back(place(p.x, p.y));
                mesh.texCoords[0].emplace_back(p.x, 1.0f - p.y);
            }
        }
    }
    return mesh;
}

Scene makeScene(const Mesh& mesh, const glm::mat4& worldFromObject = glm::mat4(1.0f)) {
    Scene scene;
    scene.name = "lamp.gltf";
    scene.materials.emplace_back().emissiveFactor = {100, 200, 300};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({"lamp", 0, worldFromObject});
    return scene;
}

/// A picture of `width` x `height` pixels for the material.
void addTexture(Scene& scene, int width, int height,
                const std::function<glm::u8vec3(int, int)>& color) {
    PixelImage image;
    image.width = width;
    image.height = height;
    image.channelCount = 3;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) image.pixels.push_back(color(x, y)[c]);
        }
    }
    scene.images.push_back(image);
    scene.textures.push_back({0, {}, ColorSpace::srgb});
    scene.materials.front().emissive.texture = 0;
}

const PolygonLight& light(const Scene& scene, std::size_t index = 0) {
    return std::get<PolygonLight>(scene.areaLights.at(index).shape);
}

double area(const PolygonLight& polygon) {
    glm::dvec3 sum(0.0);
    for (const auto& contour : polygon.contours) sum += 0.5 * areaVector(contour);
    return glm::length(sum);
}

double totalArea(const Scene& scene) {
    double sum = 0.0;
    for (std::size_t i = 0; i < scene.areaLights.size(); ++i) sum += area(light(scene, i));
    return sum;
}

TEST(EmissiveLightsTest, aPanelOf200TrianglesIsOneQuadrilateral) {
    const InfoLog log;
    Scene scene = makeScene(makeGrid(10, 10));
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_EQ(scene.areaLights[0].name, "lamp");
    EXPECT_EQ(scene.areaLights[0].place, "lamp.gltf: emissive mesh \"panel\"");
    ASSERT_THAT(light(scene).contours, SizeIs(1));
    EXPECT_THAT(light(scene).contours[0],
                testing::UnorderedElementsAre(glm::vec3(0, 0, 0), glm::vec3(1, 0, 0),
                                              glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)));
    EXPECT_GT(areaVector(light(scene).contours[0]).z, 0.0);
    EXPECT_EQ(light(scene).radiance, glm::vec3(100, 200, 300));
    EXPECT_FALSE(light(scene).twoSided);
    EXPECT_FALSE(light(scene).texture.has_value());
    EXPECT_TRUE(light(scene).shownBySurface);
    EXPECT_TRUE(scene.materials[0].emissionIsLight);
    EXPECT_THAT(log.lines, ElementsAre(AllOf(HasSubstr("\"panel\" of 200 triangles: 1 polygon"),
                                             testing::Not(HasSubstr("not planar")))));
    EXPECT_THAT(log.warnings, IsEmpty());
}

TEST(EmissiveLightsTest, onlyEmissiveMaterialsBecomeLights) {
    Scene scene = makeScene(makeGrid(1, 1));
    scene.materials[0].emissiveFactor = glm::vec3(0.0f);
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, IsEmpty());
    scene.materials[0].emissiveFactor = glm::vec3(1.0f);
    scene.materials[0].unlit = true;
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, IsEmpty());
    EXPECT_FALSE(scene.materials[0].emissionIsLight);
}

TEST(EmissiveLightsTest, doubleSidedMaterialsMakeTwoSidedLights) {
    Scene scene = makeScene(makeGrid(1, 1));
    scene.materials[0].doubleSided = true;
    addEmissiveLights(scene);
    EXPECT_TRUE(light(scene).twoSided);
}

TEST(EmissiveLightsTest, findsConcaveOutlinesAndHoles) {
    // A notch from the right in the upper half, and two holes.
    const auto keep = [](int i, int j) {
        const bool notch = j == 8 && i >= 6;
        const bool hole = (i == 2 && (j == 2 || j == 3)) || (i == 6 && j == 4);
        return !notch && !hole;
    };
    Scene scene = makeScene(makeGrid(
        10, 10, [](float x, float y) { return glm::vec3(x, y, 0); }, keep));
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    ASSERT_THAT(light(scene).contours, SizeIs(3));
    EXPECT_THAT(light(scene).contours[0], SizeIs(8));
    EXPECT_THAT(light(scene).contours[1], SizeIs(4));
    EXPECT_THAT(light(scene).contours[2], SizeIs(4));
    EXPECT_GT(areaVector(light(scene).contours[0]).z, 0.0);
    EXPECT_LT(areaVector(light(scene).contours[1]).z, 0.0);
    EXPECT_LT(areaVector(light(scene).contours[2]).z, 0.0);
    EXPECT_NEAR(area(light(scene)), 1.0 - 0.07, 1e-6);
}

TEST(EmissiveLightsTest, holesThatTouchAtAVertexStaySimple) {
    const auto keep = [](int i, int j) { return !((i == 3 && j == 3) || (i == 4 && j == 4)); };
    Scene scene = makeScene(makeGrid(
        10, 10, [](float x, float y) { return glm::vec3(x, y, 0); }, keep));
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_NEAR(area(light(scene)), 0.98, 1e-6);
    for (const auto& contour : light(scene).contours) EXPECT_LE(contour.size(), 8u);
}

TEST(EmissiveLightsTest, separatePanelsAreSeparateLights) {
    Scene scene = makeScene(makeGrid(
        9, 3, [](float x, float y) { return glm::vec3(x, y, 0); },
        [](int i, int) { return i != 2 && i != 5; }));
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, SizeIs(3));
    EXPECT_NEAR(totalArea(scene), 7.0 / 9.0, 1e-6);
}

TEST(EmissiveLightsTest, aBentSheetIsSplitAndTheLogSaysSo) {
    // Three flat parts, at 45 degrees to each other.
    const auto fold = [](float x, float y) {
        const float c = std::sqrt(0.5f);
        if (x <= 1.0f / 3.0f) return glm::vec3(x, y, 0.0f);
        if (x <= 2.0f / 3.0f) {
            const float s = x - 1.0f / 3.0f;
            return glm::vec3(1.0f / 3.0f + c * s, y, c * s);
        }
        return glm::vec3(1.0f / 3.0f + c / 3.0f, y, c / 3.0f + x - 2.0f / 3.0f);
    };
    const InfoLog log;
    Scene scene = makeScene(makeGrid(12, 4, fold));
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, SizeIs(3));
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_THAT(light(scene, i).contours.at(0), SizeIs(4));
        EXPECT_NEAR(area(light(scene, i)), 1.0 / 3.0, 1e-6);
    }
    EXPECT_THAT(log.lines,
                ElementsAre(HasSubstr("not planar: 1 connected surface split into 3 planar ones")));
}

TEST(EmissiveLightsTest, aBallBecomesManyLightsWithAWarning) {
    const auto ball = [](float x, float y) {
        const float azimuth = 2.0f * std::numbers::pi_v<float> * x;
        const float polar = std::numbers::pi_v<float> * (1.0f - y);
        return glm::vec3(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                         std::cos(polar));
    };
    const InfoLog log;
    Scene scene = makeScene(makeGrid(24, 12, ball));
    addEmissiveLights(scene);
    // Cells are flat trapezoids; the two rings at the poles, triangles.
    EXPECT_THAT(scene.areaLights, SizeIs(24 * 12));
    for (std::size_t i = 0; i < scene.areaLights.size(); ++i) {
        const auto& contour = light(scene, i).contours.at(0);
        EXPECT_LE(contour.size(), 4u);
        // Outward.
        EXPECT_GT(glm::dot(areaVector(contour), glm::dvec3(contour[0])), 0.0);
    }
    EXPECT_NEAR(totalArea(scene), 4.0 * std::numbers::pi, 0.02 * 4.0 * std::numbers::pi);
    EXPECT_THAT(log.warnings, ElementsAre(HasSubstr("became 288 polygon lights")));
}

TEST(EmissiveLightsTest, instancesAreTakenInTheWorldMirroredOnesToo) {
    const glm::mat4 place =
        glm::translate(glm::mat4(1.0f), {5, 0, 0}) * glm::scale(glm::mat4(1.0f), {2, 3, 1});
    Scene scene = makeScene(makeGrid(4, 4), place);
    scene.instances.push_back({"mirrored", 0, glm::scale(glm::mat4(1.0f), {-2, 1, 1})});
    const InfoLog log;
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(2));
    EXPECT_NEAR(area(light(scene, 0)), 6.0, 1e-5);
    EXPECT_THAT(light(scene, 0).contours[0], testing::Contains(glm::vec3(7, 3, 0)));
    EXPECT_EQ(scene.areaLights[1].name, "mirrored");
    EXPECT_THAT(light(scene, 1).contours[0], testing::Contains(glm::vec3(-2, 1, 0)));
    // The front of a mirrored instance stays where it is.
    EXPECT_GT(areaVector(light(scene, 1).contours[0]).z, 0.0);
    EXPECT_THAT(log.lines, ElementsAre(HasSubstr("64 triangles: 2 polygon lights")));
}

TEST(EmissiveLightsTest, skinnedMeshesAreTakenWhereTheirJointsPutThem) {
    test::GltfBuilder builder;
    builder.add("materials", {{"emissiveFactor", {1, 1, 1}}});
    const int joints = builder.addAccessor(std::vector<std::uint8_t>(12, 0), "VEC4", test::u8);
    const int weights = builder.addAccessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0},
                                            "VEC4", test::f32);
    // Only the joint places the mesh, not its node.
    builder.addTriangle(
        {{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}, {"material", 0}},
        {{"skin", 0}, {"translation", {9, 9, 9}}});
    builder.addNode({{"translation", {0, 5, 0}}, {"scale", {2, 2, 2}}});
    builder.add("skins", {{"joints", {1}}});
    Scene scene = builder.read();
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_THAT(
        light(scene).contours.at(0),
        testing::UnorderedElementsAre(glm::vec3(0, 5, 0), glm::vec3(2, 5, 0), glm::vec3(0, 7, 0)));
}

TEST(EmissiveLightsTest, aSheetOfTwoSidesIsTwoLights) {
    Mesh mesh = makeGrid(3, 3);
    const auto count = static_cast<std::uint32_t>(mesh.indices.size());
    for (std::uint32_t i = 0; i < count; i += 3) {
        mesh.indices.insert(mesh.indices.end(), {i, i + 2, i + 1});
    }
    Scene scene = makeScene(mesh);
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(2));
    EXPECT_LT(areaVector(light(scene, 0).contours[0]).z * areaVector(light(scene, 1).contours[0]).z,
              0.0);
    EXPECT_NEAR(totalArea(scene), 2.0, 1e-6);
}

TEST(EmissiveLightsTest, doubledAndDegenerateTrianglesCountOnce) {
    Mesh mesh = makeGrid(2, 2);
    const std::vector<std::uint32_t> indices = mesh.indices;
    mesh.indices.insert(mesh.indices.end(), indices.begin(), indices.end());
    mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 0, 1, 1});
    Scene scene = makeScene(mesh);
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_NEAR(area(light(scene)), 1.0, 1e-6);
}

TEST(EmissiveLightsTest, aRoughlyRoundedPanelFarFromTheOriginStaysOne) {
    // Single precision holds some 6e-5 there.
    const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1.0f), {800, -300, 500}), 0.7f,
                                         glm::normalize(glm::vec3(1, 2, 3)));
    Mesh mesh = makeGrid(10, 10);
    for (glm::vec3& p : mesh.positions) p = glm::vec3(turned * glm::vec4(4.0f * p, 1.0f));
    Scene scene = makeScene(mesh);
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_THAT(light(scene).contours.at(0), SizeIs(4));
    EXPECT_NEAR(area(light(scene)), 16.0, 1e-2);
}

TEST(EmissiveLightsTest, verticesOnALongEdgeLeaveNoSlit) {
    // The lower half has one vertex more on the common edge.
    Mesh mesh;
    mesh.name = "panel";
    mesh.positions = {{0, 0, 0}, {2, 0, 0},  {2, 1, 0}, {0, 1, 0},
                      {1, 0, 0}, {0, -1, 0}, {2, -1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3, 5, 4, 0, 5, 6, 4, 6, 1, 4};
    Scene scene = makeScene(mesh);
    addEmissiveLights(scene);
    EXPECT_NEAR(totalArea(scene), 4.0, 1e-6);
}

TEST(EmissiveLightsTest, theTextureLiesAsOnTheMesh) {
    Scene scene = makeScene(makeGrid(10, 10), glm::scale(glm::mat4(1.0f), {4, 2, 1}));
    addTexture(scene, 8, 8, [](int x, int y) { return glm::u8vec3(32 * x, 32 * y, 255); });
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    ASSERT_TRUE(light(scene).texture.has_value());
    const glm::dvec2 place = textureCoordinates(*light(scene).texture, {1, 0.5, 0});
    EXPECT_NEAR(place.x, 0.25, 1e-6);
    EXPECT_NEAR(place.y, 0.75, 1e-6);
    EXPECT_EQ(light(scene).texture->image->size, glm::ivec2(8));
    EXPECT_EQ(light(scene).texture->wrapU, TextureWrap::repeat);
}

TEST(EmissiveLightsTest, texturesThatBendAreSplit) {
    // Twice as dense from the middle on.
    Mesh mesh = makeGrid(10, 10);
    for (glm::vec2& t : mesh.texCoords[0]) t.x = t.x <= 0.5f ? t.x : 2.0f * t.x - 0.5f;
    Scene scene = makeScene(mesh);
    addTexture(scene, 64, 64, [](int x, int y) { return glm::u8vec3(4 * x, 4 * y, 255); });
    const InfoLog log;
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(2));
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(area(light(scene, i)), 0.5, 1e-6);
    EXPECT_THAT(log.lines, ElementsAre(HasSubstr("where the texture bends")));
}

TEST(EmissiveLightsTest, blackPartsOfTheTextureAreNoLights) {
    Scene scene = makeScene(makeGrid(8, 8));
    // Lit in the left half alone, noise of JPEG elsewhere.
    addTexture(scene, 64, 64, [](int x, int) { return glm::u8vec3(x < 32 ? 255 : 2); });
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_NEAR(area(light(scene)), 0.5, 1e-6);
    scene.areaLights.clear();
    scene.images[0].pixels.assign(scene.images[0].pixels.size(), 0);
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, IsEmpty());
}

TEST(EmissiveLightsTest, oneTexelOfAPaletteIsAnEvenLight) {
    Mesh mesh = makeGrid(4, 4);
    for (glm::vec2& t : mesh.texCoords[0]) t = {0.75f, 0.25f};
    Scene scene = makeScene(mesh);
    addTexture(scene, 2, 2, [](int x, int y) { return glm::u8vec3(x == 1 && y == 0 ? 255 : 0); });
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    EXPECT_FALSE(light(scene).texture.has_value());
    EXPECT_EQ(light(scene).radiance, glm::vec3(100, 200, 300));
}

TEST(EmissiveLightsTest, aTextureThatChangesAlongOneDirectionAloneIsKept) {
    Mesh mesh = makeGrid(4, 4);
    for (glm::vec2& t : mesh.texCoords[0]) t = {0.1f + 0.3f * t.x, 0.2f + 0.4f * t.x};
    Scene scene = makeScene(mesh);
    addTexture(scene, 16, 16, [](int x, int y) { return glm::u8vec3(16 * x, 16 * y, 99); });
    addEmissiveLights(scene);
    ASSERT_THAT(scene.areaLights, SizeIs(1));
    ASSERT_TRUE(light(scene).texture.has_value());
    for (const double y : {0.0, 0.5, 1.0}) {
        const glm::dvec2 place = textureCoordinates(*light(scene).texture, {0.5, y, 0});
        // A hundredth of a texel across, and rounding.
        EXPECT_NEAR(place.x, 0.25, 1e-3);
        EXPECT_NEAR(place.y, 0.40, 1e-3);
    }
}

TEST(EmissiveLightsTest, emptyMeshesAndLinesMakeNone) {
    Mesh mesh = makeGrid(2, 2, [](float x, float) { return glm::vec3(x, 0, 0); });
    Scene scene = makeScene(mesh);
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, IsEmpty());
    scene = makeScene(Mesh{});
    addEmissiveLights(scene);
    EXPECT_THAT(scene.areaLights, IsEmpty());
}

}  // namespace
}  // namespace polylume::scene
