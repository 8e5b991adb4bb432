// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/material_override.hpp"

#include <gtest/gtest.h>

namespace polylume {
namespace {

/// Three materials: factors alone, a texture of three channels, and a grey one of 16 bits.
scene::Scene makeScene() {
    scene::Scene scene;
    scene.images.push_back({2, 1, 3, 8, {10, 20, 30, 40, 50, 60}});
    scene.images.push_back({1, 1, 1, 16, {0x34, 0x12}});
    scene.textures.push_back({0, {}, scene::ColorSpace::linear});
    scene.textures.push_back({1, {}, scene::ColorSpace::linear});
    scene.materials.resize(3);
    scene.materials[0].roughnessFactor = 0.3f;
    scene.materials[0].metallicFactor = 0.2f;
    scene.materials[1].metallicRoughness.texture = 0;
    scene.materials[1].roughnessFactor = 0.7f;
    scene.materials[2].metallicRoughness.texture = 1;
    return scene;
}

TEST(MaterialOverrideTest, bothLeaveNoTexture) {
    scene::Scene scene = makeScene();
    MaterialOverride override(scene);
    override.apply(scene, 0.25f, 1.0f);
    for (const scene::Material& material : scene.materials) {
        EXPECT_EQ(material.roughnessFactor, 0.25f);
        EXPECT_EQ(material.metallicFactor, 1.0f);
        EXPECT_EQ(material.metallicRoughness.texture, -1);
    }
    EXPECT_EQ(scene.textures.size(), 2u);
}

TEST(MaterialOverrideTest, oneLeavesWhatTheTextureSaysOfTheOther) {
    scene::Scene scene = makeScene();
    MaterialOverride override(scene);
    override.apply(scene, 0.25f, std::nullopt);
    EXPECT_EQ(scene.materials[0].roughnessFactor, 0.25f);
    EXPECT_EQ(scene.materials[0].metallicFactor, 0.2f);
    ASSERT_EQ(scene.textures.size(), 4u);
    const scene::Texture& texture =
        scene.textures[static_cast<std::size_t>(scene.materials[1].metallicRoughness.texture)];
    EXPECT_EQ(scene.images[static_cast<std::size_t>(texture.image)].pixels,
              (std::vector<std::uint8_t>{10, 255, 30, 40, 255, 60}));
    // Grey is metalness as well.
    const scene::Texture& grey =
        scene.textures[static_cast<std::size_t>(scene.materials[2].metallicRoughness.texture)];
    const PixelImage& image = scene.images[static_cast<std::size_t>(grey.image)];
    EXPECT_EQ(image.channelCount, 3);
    EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{0x34, 0x12, 0xFF, 0xFF, 0x34, 0x12}));
}

TEST(MaterialOverrideTest, copiesAreMadeOnceAndAllIsTakenBack) {
    scene::Scene scene = makeScene();
    const scene::Scene before = scene;
    MaterialOverride override(scene);
    for (int i = 0; i < 5; ++i) {
        override.apply(scene, 0.1f * static_cast<float>(i), std::nullopt);
        override.apply(scene, std::nullopt, 0.1f * static_cast<float>(i));
    }
    EXPECT_EQ(scene.textures.size(), 2u + 4u);
    override.apply(scene, std::nullopt, std::nullopt);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        EXPECT_EQ(scene.materials[i].roughnessFactor, before.materials[i].roughnessFactor);
        EXPECT_EQ(scene.materials[i].metallicFactor, before.materials[i].metallicFactor);
        EXPECT_EQ(scene.materials[i].metallicRoughness.texture,
                  before.materials[i].metallicRoughness.texture);
    }
}

}  // namespace
}  // namespace polylume
