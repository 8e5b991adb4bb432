// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <filesystem>
#include <string>

namespace polylume {
namespace {

namespace fs = std::filesystem;

struct Loaded {
    tinygltf::Model model;
    bool isGood = false;
    std::string error;
};

/// As any program reads a file by tinygltf, without a line of ours.
Loaded load(const fs::path& path) {
    Loaded loaded;
    tinygltf::TinyGLTF reader;
    std::string warning;
    loaded.isGood =
        path.extension() == ".glb"
            ? reader.LoadBinaryFromFile(&loaded.model, &loaded.error, &warning, path.string())
            : reader.LoadASCIIFromFile(&loaded.model, &loaded.error, &warning, path.string());
    return loaded;
}

TEST(ForeignReaderTest, opensEverySample) {
    int count = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(POLYLUME_SOURCE_DIR) / "samples")) {
        const fs::path& path = entry.path();
        if (path.extension() != ".gltf" && path.extension() != ".glb") continue;
        ++count;
        const Loaded loaded = load(path);
        EXPECT_TRUE(loaded.isGood) << path << ": " << loaded.error;
        EXPECT_TRUE(loaded.error.empty()) << path << ": " << loaded.error;
        EXPECT_FALSE(loaded.model.nodes.empty()) << path;
        EXPECT_TRUE(loaded.model.extensionsRequired.empty()) << path;
    }
    EXPECT_GE(count, 4);
}

TEST(ForeignReaderTest, seesMeshesAndCamerasBesideTheLights) {
    const Loaded loaded =
        load(fs::path(POLYLUME_SOURCE_DIR) / "samples/POLYLUME_lights_area/every_shape.gltf");
    ASSERT_TRUE(loaded.isGood) << loaded.error;
    EXPECT_EQ(loaded.model.meshes.size(), 1u);
    EXPECT_EQ(loaded.model.cameras.size(), 1u);
    EXPECT_EQ(loaded.model.images.at(0).width, 8);
    EXPECT_TRUE(loaded.model.extensions.contains("POLYLUME_lights_area"));
}

TEST(ForeignReaderTest, theFixtureNoticesABrokenFile) {
    EXPECT_FALSE(load(fs::path(POLYLUME_SOURCE_DIR) / "README.md").isGood);
}

}  // namespace
}  // namespace polylume
