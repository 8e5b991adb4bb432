// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Accessors, topology and vertex attributes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;
using testing::SizeIs;

std::vector<glm::vec3> corners(const Mesh& mesh) {
    std::vector<glm::vec3> positions;
    for (const std::uint32_t index : mesh.indices) positions.push_back(mesh.positions[index]);
    return positions;
}

template <typename T>
Scene readIndexed(ComponentType type) {
    GltfBuilder builder;
    const int indices = builder.addAccessor(std::vector<T>{2, 1, 0}, "SCALAR", type);
    const int normals =
        builder.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", f32);
    builder.addTriangle({{"indices", indices}, {"attributes", {{"NORMAL", normals}}}});
    return builder.read();
}

TEST(GltfGeometryTest, readsEveryIndexType) {
    EXPECT_THAT(readIndexed<std::uint8_t>(u8).meshes.at(0).indices, ElementsAre(2, 1, 0));
    EXPECT_THAT(readIndexed<std::uint16_t>(u16).meshes.at(0).indices, ElementsAre(2, 1, 0));
    EXPECT_THAT(readIndexed<std::uint32_t>(u32).meshes.at(0).indices, ElementsAre(2, 1, 0));
}

TEST(GltfGeometryTest, takesVerticesInOrderWithoutIndices) {
    GltfBuilder builder;
    builder.addTriangle();
    const Scene scene = builder.read();
    EXPECT_THAT(corners(scene.meshes.at(0)),
                ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(GltfGeometryTest, givesFlatNormalsToUnsharedVerticesWithoutNormals) {
    GltfBuilder builder;
    const int positions = builder.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    // Two faces of a tetrahedron with a common edge.
    const int indices =
        builder.addAccessor(std::vector<std::uint8_t>{0, 1, 2, 0, 2, 3}, "SCALAR", u8);
    builder.addMeshNode({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
    const Scene scene = builder.read();
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_THAT(mesh.positions, SizeIs(6));
    EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
    EXPECT_EQ(mesh.normals[3], glm::vec3(1, 0, 0));
    EXPECT_THAT(mesh.tangents, SizeIs(6));
}

TEST(GltfGeometryTest, readsStripsAndFansInTheWindingOfTheSpecification) {
    for (const int mode : {5, 6}) {
        GltfBuilder builder;
        // Of both the first two triangles face +Z: a zigzag and a circle.
        const int positions = mode == 5
                                  ? builder.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
                                  : builder.addPositions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
        builder.addMeshNode({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
        const Scene scene = builder.read();
        ASSERT_THAT(scene.meshes.at(0).normals, SizeIs(6));
        for (const glm::vec3& normal : scene.meshes[0].normals) {
            EXPECT_EQ(normal, glm::vec3(0, 0, 1)) << "mode " << mode;
        }
    }
}

TEST(GltfGeometryTest, passesOverPointsAndLinesWithOneWarning) {
    const WarningLog log;
    GltfBuilder builder;
    builder.addTriangle({{"mode", 0}});
    builder.addTriangle({{"mode", 1}});
    EXPECT_TRUE(builder.read().instances.empty());
    EXPECT_THAT(log.messages, ElementsAre(HasSubstr("points and lines")));
}

TEST(GltfGeometryTest, readsInterleavedAttributes) {
    GltfBuilder builder;
    const std::vector<float> values{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
    std::vector<std::byte> bytes(values.size() * sizeof(float));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    const int view = builder.addView(bytes, 24);
    json accessor{{"bufferView", view}, {"componentType", f32}, {"count", 3}, {"type", "VEC3"}};
    const int positions = builder.add("accessors", accessor);
    accessor["byteOffset"] = 12;
    const int normals = builder.add("accessors", accessor);
    builder.addMeshNode({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    const Scene scene = builder.read();
    EXPECT_THAT(scene.meshes.at(0).positions,
                ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    EXPECT_EQ(scene.meshes[0].normals[2], glm::vec3(0, 0, 1));
}

TEST(GltfGeometryTest, readsQuantizedPositionsAndNormalizedNormals) {
    GltfBuilder builder;
    builder.document["extensionsRequired"] = {"KHR_mesh_quantization"};
    const int positions =
        builder.addAccessor(std::vector<std::int16_t>{0, 0, 0, 100, 0, 0, 0, -200, 0}, "VEC3", i16);
    // -128 means -1, as -127 does; each in a row of 4 bytes.
    const int normals = builder.addAccessor(
        std::vector<std::int8_t>{-128, 0, 0, 0, -127, 0, 0, 0, 127, 0, 0, 0}, "VEC4", i8, true);
    builder.document["accessors"][normals]["type"] = "VEC3";
    builder.document["bufferViews"][normals]["byteStride"] = 4;
    builder.addMeshNode({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
    const Mesh mesh = builder.read().meshes.at(0);
    EXPECT_EQ(mesh.positions[2], glm::vec3(0, -200, 0));
    EXPECT_THAT(mesh.normals,
                ElementsAre(glm::vec3(-1, 0, 0), glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0)));
}

TEST(GltfGeometryTest, readsTextureCoordinatesAndColors) {
    GltfBuilder builder;
    const int uv0 = builder.addAccessor(std::vector<std::uint16_t>{0, 65535, 0, 0, 65535, 0},
                                        "VEC2", u16, true);
    const int uv1 = builder.addAccessor(std::vector<float>{2, 3, 4, 5, 6, 7}, "VEC2", f32);
    const int colors =
        builder.addAccessor(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, .5f}, "VEC3", f32);
    builder.addTriangle(
        {{"attributes", {{"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}, {"COLOR_0", colors}}}});
    const Mesh mesh = builder.read().meshes.at(0);
    EXPECT_EQ(mesh.texCoords[0][0], glm::vec2(0, 1));
    EXPECT_EQ(mesh.texCoords[1][2], glm::vec2(6, 7));
    EXPECT_EQ(mesh.colors[2], glm::vec4(0, 0, 0.5f, 1));
}

TEST(GltfGeometryTest, readsSparseAccessorsWithAndWithoutABase) {
    for (const bool hasBase : {true, false}) {
        GltfBuilder builder;
        const int positions = builder.addPositions({5, 5, 5, 6, 6, 6, 7, 7, 7});
        const int indices = builder.addAccessor(std::vector<std::uint8_t>{1, 2}, "SCALAR", u8);
        const int values = builder.addPositions({1, 0, 0, 0, 1, 0});
        json& accessor = builder.document["accessors"][positions];
        accessor["sparse"] = {
            {"count", 2},
            {"indices",
             {{"bufferView", builder.document["accessors"][indices]["bufferView"]},
              {"componentType", u8}}},
            {"values", {{"bufferView", builder.document["accessors"][values]["bufferView"]}}}};
        if (!hasBase) accessor.erase("bufferView");
        builder.addMeshNode({{"attributes", {{"POSITION", positions}}}});
        EXPECT_THAT(
            builder.read().meshes.at(0).positions,
            ElementsAre(glm::vec3(hasBase ? 5 : 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
    }
}

TEST(GltfGeometryTest, readsSparseIndicesWithoutABase) {
    GltfBuilder builder;
    const int indices = builder.addAccessor(std::vector<std::uint8_t>{0, 0, 0}, "SCALAR", u8);
    const int places = builder.addAccessor(std::vector<std::uint8_t>{1, 2}, "SCALAR", u8);
    json& accessor = builder.document["accessors"][indices];
    accessor.erase("bufferView");
    const int view = builder.document["accessors"][places]["bufferView"];
    accessor["sparse"] = {{"count", 2},
                          {"indices", {{"bufferView", view}, {"componentType", u8}}},
                          {"values", {{"bufferView", view}}}};
    builder.addTriangle({{"indices", indices}});
    EXPECT_THAT(corners(builder.read().meshes.at(0)),
                ElementsAre(glm::vec3(0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0)));
}

TEST(GltfGeometryTest, readsAGlbLikeAGltf) {
    GltfBuilder builder;
    builder.addTriangle();
    const Scene fromGlb = readBytes("triangle.glb", builder.glb());
    EXPECT_EQ(fromGlb.meshes.at(0).positions, builder.read().meshes.at(0).positions);
    EXPECT_EQ(fromGlb.name, "triangle.glb");
}

TEST(GltfGeometryTest, readsBuffersFromPercentEncodedFiles) {
    GltfBuilder builder;
    builder.addTriangle();
    std::filesystem::create_directories("GltfGeometryTest.readsBuffersFromPercentEncodedFiles");
    writeBytes("GltfGeometryTest.readsBuffersFromPercentEncodedFiles/my data.bin", builder.buffer);
    builder.document["buffers"] =
        json::array({{{"byteLength", builder.buffer.size()}, {"uri", "my%20data.bin"}}});
    EXPECT_THAT(builder.read().meshes.at(0).positions, SizeIs(3));
}

TEST(GltfGeometryTest, makesNoNanOfDegenerateTriangles) {
    GltfBuilder builder;
    const int positions = builder.addPositions({1, 1, 1, 1, 1, 1, 1, 1, 1});
    builder.addMeshNode({{"attributes", {{"POSITION", positions}}}});
    const Mesh mesh = builder.read().meshes.at(0);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_THAT(glm::length(mesh.normals[i]), FloatEq(1.0f));
        EXPECT_THAT(glm::length(glm::vec3(mesh.tangents[i])), FloatEq(1.0f));
    }
}

TEST(GltfGeometryTest, repairsNormalsAndTangentsOfNoUse) {
    const WarningLog log;
    GltfBuilder builder;
    const float nan = std::nanf("");
    const int normals =
        builder.addAccessor(std::vector<float>{0, 0, 0, nan, 0, 0, 0, 0, 3}, "VEC3", f32);
    const int tangents = builder.addAccessor(
        std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0.5f, 2, 0, 0, -1}, "VEC4", f32);
    builder.addTriangle({{"attributes", {{"NORMAL", normals}, {"TANGENT", tangents}}}});
    const Mesh mesh = builder.read().meshes.at(0);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    for (const glm::vec4& tangent : mesh.tangents) {
        EXPECT_EQ(tangent.z, 0.0f);
        EXPECT_THAT(glm::length(glm::vec3(tangent)), FloatEq(1.0f));
    }
    EXPECT_EQ(mesh.tangents[1].w, 1.0f);
    EXPECT_EQ(mesh.tangents[2], glm::vec4(1, 0, 0, -1));
    EXPECT_THAT(log.messages, ElementsAre(HasSubstr("not finite")));
}

}  // namespace
}  // namespace polylume::scene::test
