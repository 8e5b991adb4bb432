// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "scene/surface_frame.hpp"

namespace polylume::scene {
namespace {

constexpr float kTolerance = 1e-6f;

/// A square in the plane z = 0 that shows the image upright: u to the right, v down.
Mesh square() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, glm::vec3(0, 0, 1));
    mesh.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

void expectTangent(const glm::vec4& found, const glm::vec4& expected) {
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], expected[i], kTolerance) << "at " << i;
}

TEST(TangentsTest, pointAlongUWithTheImageUpAlongTheBitangent) {
    Mesh mesh = square();
    makeTangents(mesh, 0);
    // cross(n, t) * w is +y: up in the image, where a normal map's green points.
    for (const glm::vec4& tangent : mesh.tangents) expectTangent(tangent, {1, 0, 0, 1});
}

TEST(TangentsTest, turnWithTheTextureCoordinatesAndTheirSet) {
    Mesh mesh = square();
    mesh.texCoords[1] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    makeTangents(mesh, 1);
    // u grows along +y, v along +x: the image is upright again, turned by a quarter.
    for (const glm::vec4& tangent : mesh.tangents) expectTangent(tangent, {0, 1, 0, 1});
}

TEST(TangentsTest, areMirroredWithTheImage) {
    Mesh mesh = square();
    for (glm::vec2& uv : mesh.texCoords[0]) uv.x = 1 - uv.x;
    makeTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) expectTangent(tangent, {-1, 0, 0, -1});
}

TEST(TangentsTest, splitVerticesBetweenMirroredHalves) {
    // Two squares that meet at x = 1, where u turns back.
    Mesh mesh = square();
    mesh.positions.insert(mesh.positions.end(), {{2, 0, 0}, {2, 1, 0}});
    mesh.normals.assign(6, glm::vec3(0, 0, 1));
    mesh.texCoords[0].insert(mesh.texCoords[0].end(), {{0, 1}, {0, 0}});
    mesh.indices.insert(mesh.indices.end(), {1, 4, 5, 1, 5, 2});
    makeTangents(mesh, 0);
    ASSERT_EQ(mesh.positions.size(), 8u);
    ASSERT_EQ(mesh.texCoords[0].size(), 8u);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const bool isMirrored = i >= 6;
        expectTangent(mesh.tangents[mesh.indices[i]],
                      isMirrored ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1));
    }
}

TEST(TangentsTest, agreeForEqualVerticesThatAreNotShared) {
    Mesh shared = square();
    // Out of the plane, so that the two triangles differ.
    shared.positions[3].z = 0.7f;
    shared.texCoords[0][3] = {0.2f, -0.1f};
    Mesh unshared;
    for (const std::uint32_t index : shared.indices) {
        unshared.indices.push_back(static_cast<std::uint32_t>(unshared.positions.size()));
        unshared.positions.push_back(shared.positions[index]);
        unshared.normals.push_back(shared.normals[index]);
        unshared.texCoords[0].push_back(shared.texCoords[0][index]);
    }
    makeTangents(shared, 0);
    makeTangents(unshared, 0);
    for (std::size_t i = 0; i < shared.indices.size(); ++i) {
        expectTangent(unshared.tangents[i], shared.tangents[shared.indices[i]]);
    }
}

TEST(TangentsTest, areAnyPerpendicularWithoutUsableTextureCoordinates) {
    Mesh mesh = square();
    mesh.texCoords[0].assign(4, glm::vec2(0.5f));
    makeTangents(mesh, 0);
    for (const glm::vec4& tangent : mesh.tangents) {
        EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, kTolerance);
        EXPECT_NEAR(tangent.z, 0.0f, kTolerance);
        EXPECT_EQ(tangent.w, 1.0f);
    }
}

TEST(TangentsTest, perpendicularIsOneForAnyDirection) {
    for (int i = 0; i < 1000; ++i) {
        const float polar = 0.00314f * static_cast<float>(i),
                    azimuth = 0.7f * static_cast<float>(i);
        const glm::vec3 normal(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                               std::sin(polar) * std::sin(azimuth));
        EXPECT_NEAR(glm::dot(perpendicular(normal), normal), 0.0f, kTolerance);
        EXPECT_NEAR(glm::length(perpendicular(normal)), 1.0f, kTolerance);
    }
}

}  // namespace
}  // namespace polylume::scene
