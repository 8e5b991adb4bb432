// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Node hierarchy, scenes, cameras, skins and morph targets.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

using testing::SizeIs;

// Single precision keeps 24 bits; a few operations on values near 1.
constexpr float kTolerance = 1e-6f;

void expectNear(const glm::vec3& found, const glm::vec3& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], kTolerance) << "at " << i;
}

glm::vec3 placed(const Instance& instance, const glm::vec3& point) {
    return glm::vec3(instance.worldFromObject * glm::vec4(point, 1.0f));
}

TEST(GltfNodeTest, multipliesTranslationRotationAndScaleDownTheTree) {
    GltfBuilder builder;
    const float half = std::sqrt(0.5f);
    builder.addTriangle({}, {{"translation", {1, 0, 0}}, {"scale", {2, 3, -4}}});
    builder.document["nodes"].push_back(
        {{"rotation", {0, 0, half, half}}, {"translation", {0, 0, 7}}, {"children", {0}}});
    builder.document["scenes"][0]["nodes"] = {1};
    const Scene scene = builder.read();
    // (1, 1, 1) is scaled to (2, 3, -4), moved to (3, 3, -4), turned about z to (-3, 3, -4), moved.
    expectNear(placed(scene.instances.at(0), {1, 1, 1}), {-3, 3, 3});
    EXPECT_LT(glm::determinant(glm::mat3(scene.instances[0].worldFromObject)), 0.0f);
}

TEST(GltfNodeTest, readsMatricesByColumns) {
    GltfBuilder builder;
    builder.addTriangle({}, {{"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1}}});
    expectNear(placed(builder.read().instances.at(0), {1, 0, 0}), {5, 8, 7});
}

TEST(GltfNodeTest, sharesAMeshBetweenNodes) {
    GltfBuilder builder;
    builder.addTriangle();
    builder.addNode({{"mesh", 0}, {"translation", {0, 5, 0}}});
    const Scene scene = builder.read();
    EXPECT_THAT(scene.meshes, SizeIs(1));
    EXPECT_THAT(scene.instances, SizeIs(2));
    EXPECT_EQ(scene.bounds().maximum, glm::vec3(1, 6, 0));
    EXPECT_EQ(scene.bounds().minimum, glm::vec3(0, 0, 0));
}

TEST(GltfNodeTest, showsTheDefaultSceneOnly) {
    GltfBuilder builder;
    builder.addTriangle();
    builder.addTriangle({}, {{"name", "other"}});
    builder.document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    builder.document["scene"] = 1;
    EXPECT_EQ(builder.read().instances.at(0).name, "other");
    builder.document.erase("scene");
    EXPECT_EQ(builder.read().instances.at(0).name, "");
    EXPECT_THAT(builder.read().instances, SizeIs(1));
    builder.document.erase("scenes");
    EXPECT_THAT(builder.read().instances, SizeIs(2));
}

TEST(GltfNodeTest, readsADeepTree) {
    GltfBuilder builder;
    builder.addTriangle();
    const int depth = 20000;
    for (int i = 1; i <= depth; ++i) {
        builder.document["nodes"].push_back({{"children", {i - 1}}, {"translation", {1, 0, 0}}});
    }
    builder.document["scenes"][0]["nodes"] = {depth};
    EXPECT_EQ(builder.read().bounds().minimum.x, static_cast<float>(depth));
}

TEST(GltfNodeTest, keepsMeshesThatAreScaledFlat) {
    const WarningLog log;
    GltfBuilder builder;
    builder.addTriangle({}, {{"scale", {1, 0, 1}}});
    EXPECT_THAT(builder.read().instances, SizeIs(1));
    EXPECT_TRUE(log.messages.empty());
}

TEST(GltfNodeTest, leavesOutMeshesThatAreScaledToALine) {
    const WarningLog log;
    GltfBuilder builder;
    builder.addTriangle({}, {{"scale", {1, 0, 0}}});
    EXPECT_TRUE(builder.read().instances.empty());
    EXPECT_THAT(log.messages, SizeIs(1));
}

TEST(GltfNodeTest, readsCamerasWithoutTheScaleOfTheirNodes) {
    GltfBuilder builder;
    builder.add("cameras",
                {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.25}}}});
    builder.add("cameras",
                {{"type", "orthographic"},
                 {"name", "plan"},
                 {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 0}, {"zfar", 9}}}});
    const float half = std::sqrt(0.5f);
    builder.addNode({{"camera", 0},
                     {"name", "side"},
                     {"rotation", {0, half, 0, half}},
                     {"scale", {-2, 3, 5}},
                     {"translation", {1, 2, 3}}});
    builder.addNode({{"camera", 1}});
    const Scene scene = builder.read();
    ASSERT_THAT(scene.cameras, SizeIs(2));
    const Camera& side = scene.cameras[0];
    EXPECT_EQ(side.name, "side");
    // A quarter turn about y: looks along -X, as -Z turns there.
    expectNear(-glm::vec3(side.worldFromCamera[2]), {-1, 0, 0});
    expectNear(side.worldFromCamera[1], {0, 1, 0});
    expectNear(side.worldFromCamera[3], {1, 2, 3});
    EXPECT_NEAR(glm::determinant(glm::mat3(side.worldFromCamera)), 1.0f, kTolerance);
    const auto& perspective = std::get<Perspective>(side.projection);
    EXPECT_EQ(perspective.yFovRadians, 0.5f);
    EXPECT_EQ(perspective.zNear, 0.25f);
    EXPECT_FALSE(perspective.zFar);
    EXPECT_FALSE(perspective.aspectRatio);
    EXPECT_EQ(scene.cameras[1].name, "plan");
    const auto& orthographic = std::get<Orthographic>(scene.cameras[1].projection);
    EXPECT_EQ(orthographic.xMag, 2.0f);
    EXPECT_EQ(orthographic.yMag, 3.0f);
    EXPECT_EQ(orthographic.zFar, 9.0f);
}

/// A triangle with a morph target that moves its last vertex by (0, 0, 2).
GltfBuilder morphedTriangle(json node) {
    GltfBuilder builder;
    const int delta = builder.addPositions({0, 0, 0, 0, 0, 0, 0, 0, 2});
    builder.addTriangle({{"targets", json::array({{{"POSITION", delta}}})}}, std::move(node));
    return builder;
}

TEST(GltfNodeTest, appliesMorphTargetsByTheMeshsWeightsUnlessTheNodeHasItsOwn) {
    GltfBuilder builder = morphedTriangle({});
    EXPECT_EQ(builder.read().meshes.at(0).positions[2], glm::vec3(0, 1, 0));
    builder.document["meshes"][0]["weights"] = {0.5};
    const Mesh mesh = builder.read().meshes.at(0);
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, 1, 1));
    // The flat normal is that of the deformed triangle.
    expectNear(mesh.normals[0], glm::normalize(glm::vec3(0, -1, 1)));
    builder.document["nodes"][0]["weights"] = {-1};
    EXPECT_EQ(builder.read().meshes.at(0).positions[2], glm::vec3(0, 1, -2));
}

/// A triangle whose vertices follow joints 0, 1, and both half.
GltfBuilder skinnedTriangle() {
    GltfBuilder builder;
    const int joints = builder.addAccessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", u8);
    const int weights =
        builder.addAccessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 2, 2, 0, 0}, "VEC4", f32);
    const int normals =
        builder.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", f32);
    // The skinned node's own place doesn't count.
    builder.addTriangle(
        {{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}, {"NORMAL", normals}}}},
        {{"skin", 0}, {"translation", {100, 0, 0}}});
    const int first = builder.addNode({{"translation", {0, 0, 1}}});
    const int second = builder.addNode({{"translation", {0, 0, 3}}, {"scale", {2, 2, 2}}});
    const int matrices = builder.addAccessor(
        std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,  1,   //
                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1},  // one down
        "MAT4", f32);
    builder.add("skins", {{"joints", {first, second}}, {"inverseBindMatrices", matrices}});
    return builder;
}

TEST(GltfNodeTest, bakesSkinsInTheirPoseToWorldSpace) {
    const Scene scene = skinnedTriangle().read();
    const Mesh& mesh = scene.meshes.at(0);
    expectNear(mesh.positions[0], {0, 0, 1});
    // (1, 0, 0) - (0, 0, 1), doubled, plus (0, 0, 3)
    expectNear(mesh.positions[1], {2, 0, 1});
    // The mean of (0, 1, 1) and (0, 2, 1); weights of 2 and 2 are scaled to a sum of 1.
    expectNear(mesh.positions[2], {0, 1.5f, 1});
    EXPECT_EQ(scene.instances.at(0).worldFromObject, glm::mat4(1.0f));
    expectNear(mesh.normals[1], {0, 0, 1});
}

TEST(GltfNodeTest, turnsTrianglesThatJointsMirror) {
    GltfBuilder builder = skinnedTriangle();
    for (const int joint : {1, 2}) builder.document["nodes"][joint]["scale"] = {-1, 1, 1};
    const Mesh mesh = builder.read().meshes.at(0);
    const glm::vec3 a = mesh.positions[mesh.indices[0]];
    const glm::vec3 b = mesh.positions[mesh.indices[1]];
    const glm::vec3 c = mesh.positions[mesh.indices[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0f);
    expectNear(mesh.normals[0], {0, 0, 1});
}

}  // namespace
}  // namespace polylume::scene::test
