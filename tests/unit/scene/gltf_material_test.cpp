// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "polylume/error.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// One triangle with texture coordinates and the material.
GltfBuilder withMaterial(json material) {
    GltfBuilder builder;
    builder.add("materials", std::move(material));
    const int uv = builder.addAccessor(std::vector<float>{0, 1, 1, 1, 0, 0}, "VEC2", f32);
    builder.addTriangle({{"material", 0}, {"attributes", {{"TEXCOORD_0", uv}}}});
    return builder;
}

void addTexture(GltfBuilder& builder, const json& sampler) {
    builder.add("samplers", sampler);
    builder.add("images",
                {{"bufferView", builder.addView(pngBytes())}, {"mimeType", "image/jpeg"}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
}

TEST(GltfMaterialTest, givesMeshesWithoutOneTheDefault) {
    GltfBuilder builder;
    builder.addTriangle();
    const Scene scene = builder.read();
    const Material& material = scene.materials.at(scene.meshes.at(0).material);
    EXPECT_EQ(material.baseColorFactor, glm::vec4(1.0f));
    EXPECT_EQ(material.metallicFactor, 1.0f);
    EXPECT_EQ(material.roughnessFactor, 1.0f);
    EXPECT_EQ(material.baseColor.texture, -1);
    EXPECT_EQ(material.alphaMode, AlphaMode::opaque);
}

TEST(GltfMaterialTest, readsEveryFactorAndExtension) {
    const Material material =
        withMaterial({{"name", "all"},
                      {"pbrMetallicRoughness",
                       {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}},
                        {"metallicFactor", 0.5},
                        {"roughnessFactor", 0.6}}},
                      {"emissiveFactor", {0.5, 0.25, 1}},
                      {"alphaMode", "MASK"},
                      {"alphaCutoff", 0.7},
                      {"doubleSided", true},
                      {"extensions",
                       {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4000}}},
                        {"KHR_materials_ior", {{"ior", 1.8}}},
                        {"KHR_materials_specular",
                         {{"specularFactor", 0.9}, {"specularColorFactor", {1, 0.5, 2}}}},
                        {"KHR_materials_unlit", json::object()}}}})
            .read()
            .materials.at(0);
    EXPECT_EQ(material.name, "all");
    EXPECT_EQ(material.baseColorFactor, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(material.metallicFactor, 0.5f);
    EXPECT_EQ(material.roughnessFactor, 0.6f);
    EXPECT_EQ(material.emissiveFactor, glm::vec3(2000, 1000, 4000));
    EXPECT_EQ(material.alphaMode, AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.7f);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_EQ(material.ior, 1.8f);
    EXPECT_EQ(material.specularFactor, 0.9f);
    EXPECT_EQ(material.specularColorFactor, glm::vec3(1, 0.5f, 2));
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(withMaterial({{"alphaMode", "BLEND"}}).read().materials.at(0).alphaMode,
              AlphaMode::blend);
}

TEST(GltfMaterialTest, clampsFactorsOutOfRangeWithAWarning) {
    const WarningLog log;
    const Material material =
        withMaterial({{"pbrMetallicRoughness", {{"metallicFactor", -1}, {"roughnessFactor", 7}}},
                      {"alphaMode", "GLOW"}})
            .read()
            .materials.at(0);
    EXPECT_EQ(material.metallicFactor, 0.0f);
    EXPECT_EQ(material.roughnessFactor, 1.0f);
    EXPECT_THAT(log.messages,
                ElementsAre(HasSubstr("metallicFactor is -1"), HasSubstr("roughnessFactor is 7"),
                            HasSubstr("\"GLOW\"")));
}

json makeSheen(json sheen) {
    return {{"extensions", {{"KHR_materials_sheen", std::move(sheen)}}}};
}

TEST(GltfMaterialTest, readsSheen) {
    const Material material = withMaterial(makeSheen({{"sheenColorFactor", {0.5, 0.25, 1}},
                                                      {"sheenRoughnessFactor", 0.3}}))
                                  .read()
                                  .materials.at(0);
    EXPECT_EQ(material.sheenColorFactor, glm::vec3(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(material.sheenRoughnessFactor, 0.3f);
    // Black by default, which is no sheen.
    const Scene bare = withMaterial(makeSheen({{"sheenRoughnessFactor", 0.3}})).read();
    EXPECT_EQ(bare.materials.at(0).sheenColorFactor, glm::vec3(0.0f));
    EXPECT_FALSE(bare.hasSheen());
}

TEST(GltfMaterialTest, readsTheTexturesOfSheenWhereItHasAColor) {
    const json textures = {{"sheenColorTexture", {{"index", 0}}},
                           {"sheenRoughnessTexture", {{"index", 0}}}};
    json colored = textures;
    colored["sheenColorFactor"] = {1, 1, 1};
    GltfBuilder builder = withMaterial(makeSheen(colored));
    addTexture(builder, json::object());
    const Scene scene = builder.read();
    const Material& material = scene.materials.at(0);
    EXPECT_TRUE(scene.hasSheen());
    EXPECT_EQ(scene.textures.at(material.sheenColor.texture).colorSpace, ColorSpace::srgb);
    EXPECT_EQ(scene.textures.at(material.sheenRoughness.texture).colorSpace, ColorSpace::linear);

    GltfBuilder black = withMaterial(makeSheen(textures));
    addTexture(black, json::object());
    EXPECT_THAT(black.read().images, IsEmpty());
}

TEST(GltfMaterialTest, clampsSheenOutOfRangeWithAWarning) {
    const WarningLog log;
    const Material material =
        withMaterial(makeSheen({{"sheenColorFactor", {2, -1, 0.5}}, {"sheenRoughnessFactor", 7}}))
            .read()
            .materials.at(0);
    EXPECT_EQ(material.sheenColorFactor, glm::vec3(1.0f, 0.0f, 0.5f));
    EXPECT_EQ(material.sheenRoughnessFactor, 1.0f);
    EXPECT_THAT(log.messages,
                ElementsAre(HasSubstr("KHR_materials_sheen.sheenColorFactor is 2"),
                            HasSubstr("KHR_materials_sheen.sheenColorFactor is -1"),
                            HasSubstr("KHR_materials_sheen.sheenRoughnessFactor is 7")));
}

TEST(GltfMaterialTest, namesSheenOfTheWrongType) {
    const std::pair<json, const char*> cases[] = {
        {{{"sheenColorFactor", {1, 1}}}, "sheenColorFactor"},
        {{{"sheenColorFactor", "white"}}, "sheenColorFactor"},
        {{{"sheenRoughnessFactor", {0.5}}}, "sheenRoughnessFactor"},
        {{{"sheenColorTexture", {{"index", 7}}}}, "sheenColorTexture"},
        {{{"sheenRoughnessTexture", json::object()}}, "sheenRoughnessTexture"},
    };
    for (const auto& [sheen, name] : cases) {
        try {
            withMaterial(makeSheen(sheen)).read();
            ADD_FAILURE() << sheen;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr(name));
            EXPECT_THAT(error.what(), HasSubstr("expected"));
        }
    }
}

TEST(GltfMaterialTest, readsTexturesOfEverySlotOncePerColorSpace) {
    GltfBuilder builder = withMaterial(
        {{"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 0}}}}},
         {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
         {"occlusionTexture", {{"index", 0}, {"strength", 0.25}}},
         {"emissiveTexture", {{"index", 0}}},
         {"extensions",
          {{"KHR_materials_specular",
            {{"specularTexture", {{"index", 0}}}, {"specularColorTexture", {{"index", 0}}}}}}}});
    addTexture(builder,
               {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}});
    const Scene scene = builder.read();
    const Material& material = scene.materials.at(0);
    ASSERT_THAT(scene.textures, SizeIs(2));
    ASSERT_THAT(scene.images, SizeIs(1));
    for (const TextureSlot* slot :
         {&material.baseColor, &material.emissive, &material.specularColor}) {
        EXPECT_EQ(scene.textures.at(slot->texture).colorSpace, ColorSpace::srgb);
    }
    for (const TextureSlot* slot :
         {&material.metallicRoughness, &material.normal, &material.occlusion, &material.specular}) {
        EXPECT_EQ(scene.textures.at(slot->texture).colorSpace, ColorSpace::linear);
    }
    EXPECT_EQ(material.normalScale, 0.5f);
    EXPECT_EQ(material.occlusionStrength, 0.25f);
    const Sampler expected{.magFilter = Filter::nearest,
                           .minFilter = Filter::linear,
                           .mipFilter = MipFilter::nearest,
                           .wrapU = Wrap::clampToEdge,
                           .wrapV = Wrap::mirroredRepeat};
    EXPECT_EQ(scene.textures[0].sampler, expected);
    // A PNG, whatever its MIME type says.
    EXPECT_EQ(scene.images[0].width, 2);
    EXPECT_EQ(scene.images[0].height, 2);
    EXPECT_THAT(std::vector<std::uint8_t>(scene.images[0].pixels.begin(),
                                          scene.images[0].pixels.begin() + 6),
                ElementsAre(255, 0, 0, 0, 255, 0));
}

TEST(GltfMaterialTest, readsImagesOfDataUrisAndFiles) {
    const json material{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
    const std::string folder = "GltfMaterialTest.readsImagesOfDataUrisAndFiles";
    std::filesystem::create_directories(folder);
    writeBytes(folder + "/a b.png", pngBytes());
    for (const std::string& uri :
         {std::string("a%20b.png"), "data:image/png;base64," + base64(pngBytes())}) {
        GltfBuilder builder = withMaterial(material);
        builder.add("images", {{"uri", uri}});
        builder.add("textures", {{"source", 0}});
        EXPECT_EQ(builder.read().images.at(0).width, 2) << uri.substr(0, 30);
    }
}

TEST(GltfMaterialTest, decodesOnlyImagesThatAreUsed) {
    GltfBuilder builder = withMaterial(json::object());
    builder.add("materials", {{"emissiveTexture", {{"index", 0}}}});
    builder.add("images", {{"uri", "nowhere.png"}});
    builder.add("textures", {{"source", 0}});
    EXPECT_THAT(builder.read().images, IsEmpty());
}

TEST(GltfMaterialTest, appliesTextureTransforms) {
    GltfBuilder builder = withMaterial({{"normalTexture",
                                         {{"index", 0},
                                          {"extensions",
                                           {{"KHR_texture_transform",
                                             {{"offset", {0.5, 0.25}},
                                              {"rotation", M_PI / 2},
                                              {"scale", {2, 4}},
                                              {"texCoord", 1}}}}}}}});
    addTexture(builder, json::object());
    const TextureSlot slot = builder.read().materials.at(0).normal;
    EXPECT_EQ(slot.texCoordSet, 1);
    // Counter-clockwise as the image is seen: +u turns to the image's top, -v.
    const glm::vec3 alongU = slot.uvFromTexCoord * glm::vec3(1, 0, 1);
    const glm::vec3 alongV = slot.uvFromTexCoord * glm::vec3(0, 1, 1);
    EXPECT_NEAR(alongU.x, 0.5, 1e-6);
    EXPECT_NEAR(alongU.y, 0.25 - 2, 1e-6);
    EXPECT_NEAR(alongV.x, 0.5 + 4, 1e-6);
    EXPECT_NEAR(alongV.y, 0.25, 1e-6);
}

}  // namespace
}  // namespace polylume::scene::test
