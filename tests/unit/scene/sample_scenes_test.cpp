// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// The scenes under samples/scenes, and FlightHelmet where POLYLUME_ASSETS names its folder.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "core/file.hpp"
#include "scene/gltf_reader.hpp"
#include "scene/surface_frame.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(POLYLUME_SOURCE_DIR) / "samples/scenes";

class SampleSceneTest : public testing::TestWithParam<const char*> {};

TEST_P(SampleSceneTest, readsWithoutAWarning) {
    const WarningLog log;
    const Scene scene = readGltf(kScenes / (std::string(GetParam()) + ".glb"));
    EXPECT_TRUE(log.messages.empty()) << log.messages.front();
    EXPECT_FALSE(scene.areaLights.empty());
    EXPECT_EQ(scene.cameras.size(), 1u);
    EXPECT_GT(scene.instances.size(), 5u);
    EXPECT_LT(std::filesystem::file_size(kScenes / (std::string(GetParam()) + ".glb")), 1'600'000u);
    // Normals point to the side that triangles face.
    for (const Mesh& mesh : scene.meshes) {
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const glm::vec3 a = mesh.positions[mesh.indices[i]];
            const glm::vec3 face = glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                              mesh.positions[mesh.indices[i + 2]] - a);
            const glm::vec3 mean = mesh.normals[mesh.indices[i]] +
                                   mesh.normals[mesh.indices[i + 1]] +
                                   mesh.normals[mesh.indices[i + 2]];
            ASSERT_GT(glm::dot(face, mean), 0.0f) << mesh.name << ", triangle " << i / 3;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SampleSceneTest,
                         testing::Values("gallery", "studio", "cornell", "softboxes", "neon",
                                         "city"));

TEST(SampleGeneratorTest, makesTheSameBytes) {
    const std::filesystem::path folder = "SampleGeneratorTest";
    const std::string command =
        "python3 '" + (kScenes / "generate.py").string() + "' " + folder.string() + " > /dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    for (const char* name :
         {"gallery.glb", "studio.glb", "cornell.glb", "softboxes.glb", "neon.glb", "city.glb"}) {
        EXPECT_TRUE(readFile(folder / name) == readFile(kScenes / name))
            << name << " differs; run samples/scenes/generate.py";
    }
}

TEST(FlightHelmetTest, readsWithTangentsLikeItsOwn) {
    const char* assets = std::getenv("POLYLUME_ASSETS");
    if (!assets) GTEST_SKIP() << "set POLYLUME_ASSETS to the folder that holds FlightHelmet";
    const WarningLog log;
    const Scene scene =
        readGltf(std::filesystem::path(assets) / "FlightHelmet" / "FlightHelmet.gltf");
    EXPECT_TRUE(log.messages.empty());
    EXPECT_EQ(scene.meshes.size(), 6u);
    EXPECT_EQ(scene.images.size(), 15u);
    EXPECT_EQ(scene.textures.size(), 15u);
    EXPECT_NEAR(scene.bounds().maximum.y, 0.716f, 0.001f);

    // Tangents made by another program from the same texture coordinates: the handedness has to
    // agree, and nearly all directions, within the differences between ways to weigh triangles.
    std::size_t vertexCount = 0, closeCount = 0, sameSideCount = 0;
    for (const Mesh& mesh : scene.meshes) {
        Mesh copy = mesh;
        makeTangents(copy, 0);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            ++vertexCount;
            closeCount +=
                glm::dot(glm::vec3(copy.tangents[i]), glm::vec3(mesh.tangents[i])) > 0.98f;
            sameSideCount += copy.tangents[i].w == mesh.tangents[i].w;
        }
    }
    EXPECT_GT(static_cast<double>(sameSideCount) / static_cast<double>(vertexCount), 0.99);
    EXPECT_GT(static_cast<double>(closeCount) / static_cast<double>(vertexCount), 0.95);
}

}  // namespace
}  // namespace polylume::scene::test
