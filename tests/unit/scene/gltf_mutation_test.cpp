// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Damaged files either load or throw Error, whatever the damage; run under sanitizers by
// ci/sanitize.

#include <gtest/gtest.h>

#include <random>

#include "polylume/error.hpp"
#include "polylume/light.hpp"
#include "scene/default_lighting.hpp"
#include "scene/emissive_lights.hpp"
#include "scene/framing.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

constexpr int kMutations = 2500;

/// A scene with a little of everything.
GltfBuilder everything() {
    GltfBuilder builder;
    builder.document["extensions"]["EXT_lights_area"]["lights"] =
        json::array({{{"type", "rect"}, {"size", 2}, {"rect", {{"aspect", 2}}}}});
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] =
        json::array({{{"type", "spot"}, {"spot", {{"outerConeAngle", 0.5}}}}});
    builder.document["extensions"]["POLYLUME_lights_area"]["lights"] = json::parse(R"([
        {"type": "polygon", "twoSided": true, "texture": {"index": 0},
         "polygon": {"contours": [[[0, 0, 0], [0, 2, 0], [2, 2, 0], [2, 0, 0]],
                                  [[0.5, 0.5, 0], [1, 0.5, 0], [1, 1, 0]]],
                     "texCoords": [[[1, 1], [1, 0], [0, 0], [0, 1]],
                                   [[0.75, 0.75], [0.5, 0.75], [0.5, 0.5]]]}},
        {"type": "rect", "rect": {"width": 2}, "texture": {"index": 0}},
        {"type": "tube", "tube": {"length": 3}},
        {"type": "sphere", "color": [1, 0, 0]},
        {"type": "ellipse", "ellipse": {"height": 0.5}}])");
    builder.add("images", {{"bufferView", builder.addView(pngBytes())}});
    builder.add("samplers", {{"wrapS", 33071}});
    builder.add("textures", {{"source", 0}, {"sampler", 0}});
    const json texture{{"index", 0},
                       {"extensions", {{"KHR_texture_transform", {{"rotation", 1}}}}}};
    builder.add("materials", {{"normalTexture", texture},
                              {"emissiveTexture", texture},
                              {"emissiveFactor", {1, 1, 0.5}},
                              {"pbrMetallicRoughness", {{"baseColorTexture", texture}}}});
    const int uv = builder.addAccessor(std::vector<float>{0, 1, 1, 1, 0, 0}, "VEC2", f32);
    const int joints = builder.addAccessor(
        std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC4", u8);
    const int weights = builder.addAccessor(
        std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", f32);
    const int normals =
        builder.addAccessor(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", f32);
    const int indices = builder.addAccessor(std::vector<std::uint8_t>{0, 1, 2}, "SCALAR", u8);
    const int sparse = builder.addPositions({0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.document["accessors"][sparse]["sparse"] = {
        {"count", 1},
        {"indices",
         {{"bufferView", builder.document["accessors"][indices]["bufferView"]},
          {"componentType", u8}}},
        {"values", {{"bufferView", builder.document["accessors"][normals]["bufferView"]}}}};
    builder.addTriangle({{"attributes", {{"TEXCOORD_0", uv}, {"NORMAL", normals}}},
                         {"indices", indices},
                         {"material", 0},
                         {"mode", 5},
                         {"targets", json::array({{{"POSITION", sparse}}})}},
                        {{"weights", {0.5}}, {"rotation", {0, 0, 0, 1}}});
    builder.addTriangle({{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}},
                        {{"skin", 0}});
    builder.add("cameras", {{"type", "perspective"},
                            {"perspective", {{"yfov", 0.5}, {"znear", 0.25}, {"zfar", 100}}}});
    builder.addNode({{"camera", 0}, {"extensions", {{"EXT_lights_area", {{"light", 0}}}}}});
    builder.addNode({{"children", json::array()},
                     {"scale", {1, 2, 3}},
                     {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    for (int i = 0; i < 5; ++i) {
        builder.addNode(
            {{"scale", {1, -1, 2}}, {"extensions", {{"POLYLUME_lights_area", {{"light", i}}}}}});
    }
    builder.add("skins", {{"joints", {0, 3}}});
    return builder;
}

void expectUsable(const PolygonLight& light) {
    EXPECT_NO_THROW(checkLights({{light}, {}}));
    if (!light.texture) return;
    const LightTexture& texture = *light.texture;
    EXPECT_EQ(static_cast<int>(texture.image->texels.size()),
              texture.image->size.x * texture.image->size.y);
    for (const glm::vec3& axis : {texture.origin, texture.axisU, texture.axisV}) {
        EXPECT_TRUE(std::isfinite(glm::length(axis)));
    }
}

/// Reads the file; whatever it gives has to be usable.
void readAndUse(const std::string& name, const std::vector<std::byte>& bytes) {
    try {
        Scene scene = readBytes(name, bytes);
        addEmissiveLights(scene);
        for (const Mesh& mesh : scene.meshes) {
            ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
            ASSERT_EQ(mesh.tangents.size(), mesh.positions.size());
            for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
            for (const glm::vec3& normal : mesh.normals) {
                ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
            }
            for (const glm::vec4& tangent : mesh.tangents) {
                ASSERT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-5f);
            }
        }
        for (const Instance& instance : scene.instances) {
            ASSERT_LT(static_cast<std::size_t>(instance.mesh), scene.meshes.size());
            ASSERT_TRUE(std::isfinite(glm::determinant(instance.worldFromObject)) ||
                        scene.bounds().radius() > 1e9f);
        }
        for (const AreaLight& light : scene.areaLights) {
            if (const auto* polygon = std::get_if<PolygonLight>(&light.shape)) {
                expectUsable(*polygon);
            }
        }
        const Camera camera = frameCamera(scene.bounds(), 1.5f);
        for (int i = 0; i < 16; ++i)
            ASSERT_TRUE(std::isfinite(camera.worldFromCamera[i / 4][i % 4]));
        defaultRig(scene.bounds(), camera);
    } catch (const Error& error) {
        ASSERT_NE(std::string(error.what()), "");
    }
}

TEST(GltfMutationTest, survivesDamagedBytes) {
    const std::vector<std::byte> sound = everything().glb();
    ASSERT_EQ(readError("sound.glb", sound), "");
    std::mt19937 random(20260);
    for (int i = 0; i < kMutations; ++i) {
        SCOPED_TRACE(i);
        std::vector<std::byte> bytes = sound;
        const int count = 1 + static_cast<int>(random() % 4);
        for (int k = 0; k < count; ++k) bytes[random() % bytes.size()] = std::byte(random() % 256);
        if (random() % 8 == 0) bytes.resize(random() % bytes.size());
        readAndUse("damaged.glb", bytes);
        if (HasFatalFailure()) return;
    }
}

/// Any place in the document.
json& anyValue(json& document, std::mt19937& random) {
    json* value = &document;
    while (value->is_structured() && !value->empty() && (value == &document || random() % 5 != 0)) {
        auto element = value->begin();
        std::advance(element, random() % value->size());
        value = &*element;
    }
    return *value;
}

TEST(GltfMutationTest, survivesAlteredJson) {
    const GltfBuilder sound = everything();
    const json replacements{nullptr,
                            -1,
                            0,
                            1,
                            2,
                            3,
                            5,
                            7,
                            255,
                            65536,
                            2147483647,
                            2147483648,
                            4294967295,
                            9007199254740993,
                            -9223372036854775807,
                            1e-300,
                            1e38,
                            1e300,
                            0.5,
                            true,
                            "",
                            "VEC3",
                            "MAT4",
                            "SCALAR",
                            "orthographic",
                            json::array(),
                            json::array({1}),
                            json::object(),
                            json::array({0, 0}),
                            5120,
                            5125,
                            5126};
    std::mt19937 random(20261);
    for (int i = 0; i < kMutations; ++i) {
        SCOPED_TRACE(i);
        GltfBuilder builder = sound;
        const int count = 1 + static_cast<int>(random() % 3);
        for (int k = 0; k < count; ++k) {
            json& value = anyValue(builder.document, random);
            const json other = anyValue(builder.document, random);
            value = random() % 4 == 0 ? other : replacements[random() % replacements.size()];
            if (!builder.document.is_object()) builder.document = json::object();
        }
        readAndUse("altered.glb", builder.glb());
        if (HasFatalFailure()) return;
    }
}

}  // namespace
}  // namespace polylume::scene::test
