// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/material_variant.hpp"

#include <gmock/gmock.h>

#include <set>

namespace polylume {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> definesOf(const scene::Material& material) {
    return variantDefines(materialVariant(material));
}

TEST(MaterialVariantTest, factorsAloneNeedNoDefine) {
    scene::Material material;
    EXPECT_THAT(definesOf(material), IsEmpty());
    material.baseColorFactor = {0.1f, 0.2f, 0.3f, 0.4f};
    material.doubleSided = material.unlit = true;
    EXPECT_THAT(definesOf(material), IsEmpty());
}

TEST(MaterialVariantTest, eachTextureHasItsOwn) {
    using Slot = scene::TextureSlot scene::Material::*;
    const std::pair<Slot, const char*> slots[] = {
        {&scene::Material::baseColor, "POLYLUME_BASE_COLOR_TEXTURE"},
        {&scene::Material::metallicRoughness, "POLYLUME_METALLIC_ROUGHNESS_TEXTURE"},
        {&scene::Material::normal, "POLYLUME_NORMAL_TEXTURE"},
        {&scene::Material::occlusion, "POLYLUME_OCCLUSION_TEXTURE"},
        {&scene::Material::emissive, "POLYLUME_EMISSIVE_TEXTURE"},
        {&scene::Material::specular, "POLYLUME_SPECULAR_TEXTURE"},
        {&scene::Material::specularColor, "POLYLUME_SPECULAR_COLOR_TEXTURE"},
        {&scene::Material::sheenColor, "POLYLUME_SHEEN_COLOR_TEXTURE"},
        {&scene::Material::sheenRoughness, "POLYLUME_SHEEN_ROUGHNESS_TEXTURE"},
    };
    std::set<unsigned> variants;
    for (const auto& [slot, define] : slots) {
        scene::Material material;
        (material.*slot).texture = 0;
        EXPECT_THAT(definesOf(material), ElementsAre(define));
        variants.insert(materialVariant(material));
    }
    EXPECT_EQ(variants.size(), std::size(slots));
}

TEST(MaterialVariantTest, secondTextureCoordinatesCountWhereATextureGoesByThem) {
    scene::Material material;
    material.normal.texCoordSet = 1;
    EXPECT_THAT(definesOf(material), IsEmpty());
    material.baseColor.texture = 0;
    EXPECT_THAT(definesOf(material), ElementsAre("POLYLUME_BASE_COLOR_TEXTURE"));
    material.baseColor.texCoordSet = 1;
    EXPECT_THAT(definesOf(material),
                ElementsAre("POLYLUME_BASE_COLOR_TEXTURE", "POLYLUME_TEX_COORD_1"));
}

TEST(MaterialVariantTest, slotsStandAtTheShadersUnits) {
    const scene::Material material;
    const auto slots = textureSlots(material);
    EXPECT_EQ(slots[shared::kBaseColorSlot], &material.baseColor);
    EXPECT_EQ(slots[shared::kMetallicRoughnessSlot], &material.metallicRoughness);
    EXPECT_EQ(slots[shared::kNormalSlot], &material.normal);
    EXPECT_EQ(slots[shared::kOcclusionSlot], &material.occlusion);
    EXPECT_EQ(slots[shared::kEmissiveSlot], &material.emissive);
    EXPECT_EQ(slots[shared::kSpecularSlot], &material.specular);
    EXPECT_EQ(slots[shared::kSpecularColorSlot], &material.specularColor);
    EXPECT_EQ(slots[shared::kSheenColorSlot], &material.sheenColor);
    EXPECT_EQ(slots[shared::kSheenRoughnessSlot], &material.sheenRoughness);
}

TEST(MaterialVariantTest, maskIsCompiledInAndBlendIsNot) {
    scene::Material material;
    material.alphaMode = scene::AlphaMode::mask;
    EXPECT_THAT(definesOf(material), ElementsAre("POLYLUME_ALPHA_MASK"));
    material.baseColor.texture = 3;
    EXPECT_THAT(definesOf(material),
                ElementsAre("POLYLUME_BASE_COLOR_TEXTURE", "POLYLUME_ALPHA_MASK"));
    material.alphaMode = scene::AlphaMode::blend;
    EXPECT_THAT(definesOf(material), ElementsAre("POLYLUME_BASE_COLOR_TEXTURE"));
}

}  // namespace
}  // namespace polylume
