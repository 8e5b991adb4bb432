// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Every message: what was expected, what was found, and where.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "polylume/error.hpp"
#include "scene/gltf_reader.hpp"
#include "unit/scene/gltf_builder.hpp"

namespace polylume::scene::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// What readGltf() says of a textured triangle after `change`.
std::string errorAfter(const std::function<void(GltfBuilder&)>& change) {
    GltfBuilder builder;
    const int indices = builder.addAccessor(std::vector<std::uint8_t>{0, 1, 2}, "SCALAR", u8);
    builder.addTriangle({{"indices", indices}, {"material", 0}});  // accessors 0 and 1
    builder.add("images", {{"bufferView", builder.addView(pngBytes())}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"emissiveTexture", {{"index", 0}}}});
    EXPECT_EQ(readError(builder), "") << "must be sound before the change";
    change(builder);
    return readError(builder);
}

std::string errorAfter(const char* pointer, const json& value) {
    return errorAfter(
        [&](GltfBuilder& builder) { builder.document[json::json_pointer(pointer)] = value; });
}

TEST(GltfErrorTest, namesIndicesOutOfRangeAndTheirPlace) {
    EXPECT_EQ(errorAfter("/nodes/0/mesh", 7),
              "expected \"mesh\" below 1, found 7 (scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter("/nodes/0/mesh", -1),
              "expected \"mesh\" to be 0 or more, found -1 (scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter("/nodes/0/skin", 0),
              "expected \"skin\" left out, since there is no \"skins\", found 0 (scene.gltf: "
              "nodes[0])");
    EXPECT_EQ(errorAfter("/scene", 3), "expected \"scene\" below 1, found 3 (scene.gltf)");
    EXPECT_EQ(errorAfter("/scenes/0/nodes", {0, 9}),
              "expected \"nodes[1]\" below 1, found 9 (scene.gltf: scenes[0])");
    EXPECT_EQ(
        errorAfter("/meshes/0/primitives/0/attributes/NORMAL", 5),
        "expected \"NORMAL\" below 2, found 5 (scene.gltf: meshes[0].primitives[0].attributes)");
    EXPECT_EQ(errorAfter("/materials/0/emissiveTexture/index", 2),
              "expected \"index\" below 1, found 2 (scene.gltf: materials[0].emissiveTexture)");
    EXPECT_EQ(errorAfter("/textures/0/source", 4294967296),
              "expected \"source\" below 1, found 4294967296 (scene.gltf: textures[0])");
    EXPECT_EQ(errorAfter("/accessors/0/bufferView", 1e300),
              "expected \"bufferView\" below 3, found 1e+300 (scene.gltf: accessors[0])");
}

TEST(GltfErrorTest, namesWrongTypesAndMissingProperties) {
    EXPECT_EQ(errorAfter("/nodes/0/mesh", "one"),
              "expected \"mesh\" to be an index, found \"one\" (scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter("/nodes/0/scale", {1, 2}),
              "expected \"scale\" to be an array of 3, found an array of 2 (scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter("/nodes", 5), "expected \"nodes\" to be an array, found 5 (scene.gltf)");
    EXPECT_EQ(errorAfter("/nodes/0", nullptr),
              "expected an object, found null (scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter("/bufferViews/0/byteLength", -4),
              "expected \"byteLength\" to be a whole number, 0 or more, found -4 (scene.gltf: "
              "bufferViews[0])");
    EXPECT_EQ(errorAfter("/nodes/0/translation", {1e60, 0, 0}),
              "expected \"translation[0]\" to be a number that fits single precision, found 1e+60 "
              "(scene.gltf: nodes[0])");
    EXPECT_EQ(errorAfter([](GltfBuilder& b) { b.document["accessors"][0].erase("count"); }),
              "expected \"count\", which is missing (scene.gltf: accessors[0])");
}

TEST(GltfErrorTest, namesRangesThatReachTooFar) {
    EXPECT_THAT(errorAfter("/bufferViews/0/byteOffset", 4000000000),
                AllOf(HasSubstr("bytes of buffers[0]"), HasSubstr("at 4000000000"),
                      HasSubstr("scene.gltf: bufferViews[0]")));
    EXPECT_THAT(
        errorAfter("/accessors/1/count", 2000000000),
        AllOf(HasSubstr("2000000000 elements of 12 bytes"), HasSubstr("scene.gltf: accessors[1]")));
    EXPECT_THAT(errorAfter("/accessors/1/byteOffset", 9007199254740991),
                HasSubstr("from offset 9007199254740991"));
    EXPECT_THAT(errorAfter("/bufferViews/1/byteStride", 4), HasSubstr("byteStride"));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.document["accessors"][1].erase("bufferView");
                    b.document["accessors"][1]["count"] = 2000000000;
                }),
                HasSubstr("without a buffer view"));
}

TEST(GltfErrorTest, namesAccessorsOfTheWrongKind) {
    EXPECT_THAT(errorAfter("/accessors/1/type", "VEC2"),
                AllOf(HasSubstr("POSITION to be VEC3, found VEC2"), HasSubstr("accessors[1]")));
    EXPECT_THAT(errorAfter("/accessors/0/componentType", 5126), HasSubstr("found 5126"));
    EXPECT_THAT(errorAfter("/accessors/1/componentType", 5130), HasSubstr("found 5130"));
    EXPECT_THAT(errorAfter("/accessors/1/type", "VEC9"), HasSubstr("VEC9"));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) { b.buffer[1] = std::byte{3}; }),
                AllOf(HasSubstr("indices below 3, found 3 at place 1"),
                      HasSubstr("scene.gltf: meshes[0].primitives[0].indices")));
}

TEST(GltfErrorTest, namesPositionsThatAreNotFinite) {
    for (const float bad : {std::nanf(""), HUGE_VALF, -1e20f}) {
        EXPECT_THAT(errorAfter([bad](GltfBuilder& b) { std::memcpy(&b.buffer[4 + 12], &bad, 4); }),
                    AllOf(HasSubstr("finite positions"), HasSubstr("at vertex 1"),
                          HasSubstr("meshes[0].primitives[0].POSITION")));
    }
}

TEST(GltfErrorTest, namesNodesThatFormNoTree) {
    EXPECT_THAT(errorAfter("/nodes/0/children", {0}), HasSubstr("nodes[0]"));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.document["nodes"].push_back({{"children", {2}}});
                    b.document["nodes"].push_back({{"children", {1}}});
                }),
                AllOf(HasSubstr("its own ancestor"), HasSubstr("nodes[1]")));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.addNode({{"children", {0}}});
                    b.addNode({{"children", {0}}});
                }),
                HasSubstr("one parent"));
}

TEST(GltfErrorTest, namesExtensionsThatAreRequiredAndWarnsOfThoseUsed) {
    EXPECT_THAT(errorAfter("/extensionsRequired", {"KHR_draco_mesh_compression"}),
                AllOf(HasSubstr("KHR_draco_mesh_compression"), HasSubstr("scene.gltf")));
    const WarningLog log;
    EXPECT_EQ(
        errorAfter("/extensionsUsed", {"VENDOR_b", "KHR_lights_punctual", "VENDOR_a", "VENDOR_b"}),
        "");
    EXPECT_THAT(log.messages,
                ElementsAre("scene.gltf: passed over unknown extensions: VENDOR_a, VENDOR_b"));
}

TEST(GltfErrorTest, namesMissingAndBrokenBuffersAndImages) {
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.document["buffers"] = {{{"byteLength", 100}, {"uri", "gone.bin"}}};
                }),
                AllOf(HasSubstr("gone.bin"), HasSubstr("scene.gltf: buffers[0]")));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.document["buffers"] = {{{"byteLength", 100}, {"uri", "data:;base64,AAAA"}}};
                }),
                HasSubstr("expected 100 bytes, found 3 (scene.gltf: buffers[0])"));
    EXPECT_THAT(errorAfter("/buffers", json::array({{{"byteLength", 100}}})),
                HasSubstr("expected \"uri\""));
    EXPECT_THAT(errorAfter("/images/0", {{"uri", "gone.png"}}),
                AllOf(HasSubstr("gone.png"), HasSubstr("scene.gltf: images[0]")));
    EXPECT_THAT(errorAfter("/images/0", {{"uri", "https://example.com/a.png"}}),
                AllOf(HasSubstr("https://example.com"), HasSubstr("images[0]")));
    EXPECT_THAT(errorAfter("/images/0", {{"uri", "data:image/png;base64,!!"}}),
                AllOf(HasSubstr("base64"), HasSubstr("images[0]")));
    EXPECT_THAT(errorAfter("/images/0", {{"uri", "data:image/png;base64,AAAA"}}),
                HasSubstr("scene.gltf: images[0]"));
    EXPECT_THAT(errorAfter("/images/0", json::object()), HasSubstr("images[0]"));
}

TEST(GltfErrorTest, namesTheVersion) {
    EXPECT_THAT(errorAfter("/asset/version", "1.0"),
                AllOf(HasSubstr("expected glTF version 2.0, found 1.0"), HasSubstr("scene.gltf")));
    EXPECT_THAT(errorAfter("/asset/minVersion", "2.1"), HasSubstr("found 2.1"));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) { b.document.erase("asset"); }), HasSubstr("asset"));
}

TEST(GltfErrorTest, namesTypesOfLightsAndCameras) {
    GltfBuilder builder;
    builder.document["extensions"]["EXT_lights_area"]["lights"] =
        json::array({{{"type", "rect"}}, json::object(), {{"type", "disc"}}});
    const int node = builder.addNode({{"extensions", {{"EXT_lights_area", {{"light", 2}}}}}});
    EXPECT_EQ(readError(builder),
              "expected \"type\" to be \"rect\" or \"disk\", found \"disc\" (scene.gltf: "
              "EXT_lights_area.lights[2] at nodes[0])");
    json& light = builder.document["nodes"][node]["extensions"]["EXT_lights_area"]["light"];
    light = 1;
    EXPECT_EQ(readError(builder),
              "expected \"type\" to be \"rect\" or \"disk\", found none (scene.gltf: "
              "EXT_lights_area.lights[1] at nodes[0])");
    light = 3;
    EXPECT_EQ(readError(builder),
              "expected \"light\" below 3, found 3 (scene.gltf: nodes[0].EXT_lights_area)");
    light = 0;
    EXPECT_EQ(readError(builder), "");
    GltfBuilder cameras;
    cameras.add("cameras", {{"type", "perspective"}});
    cameras.addNode({{"camera", 0}});
    EXPECT_THAT(readError(cameras), HasSubstr("cameras[0]"));
}

TEST(GltfErrorTest, namesBrokenSkinsAndMorphWeights) {
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.add("skins", {{"joints", {0}}});
                    b.document["nodes"][0]["skin"] = 0;
                }),
                AllOf(HasSubstr("JOINTS_0"), HasSubstr("skins[0]")));
    EXPECT_THAT(errorAfter([](GltfBuilder& b) {
                    b.primitive()["targets"] = {{{"POSITION", 1}}, {{"POSITION", 1}}};
                    b.document["nodes"][0]["weights"] = {1};
                }),
                HasSubstr("expected 2 weights"));
}

TEST(GltfErrorTest, namesFilesThatAreCutShort) {
    GltfBuilder builder;
    builder.addTriangle();
    const std::vector<std::byte> whole = builder.glb();
    EXPECT_EQ(readError("scene.glb", whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const std::vector<std::byte> part(whole.begin(),
                                          whole.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_THAT(readError("scene.glb", part), HasSubstr("scene.glb")) << size << " bytes";
    }
    const std::string text = builder.text();
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    EXPECT_THAT(readError("scene.gltf", {begin, begin + text.size() / 2}),
                AllOf(HasSubstr("scene.gltf"), HasSubstr("cut short")));
    std::vector<std::byte> wrong = whole;
    wrong[0] = std::byte{'x'};
    EXPECT_THAT(readError("scene.glb", wrong), HasSubstr("magic"));
    wrong = whole;
    wrong[4] = std::byte{1};
    EXPECT_THAT(readError("scene.glb", wrong), HasSubstr("found 1"));
    EXPECT_THROW(readGltf("no such file.gltf"), Error);
}

TEST(GltfErrorTest, survivesDeeplyNestedJson) {
    std::string text = R"({"asset":{"version":"2.0"},"extras":)";
    text.append(200000, '[').append(200000, ']').append("}");
    const auto* begin = reinterpret_cast<const std::byte*>(text.data());
    EXPECT_EQ(readError("scene.gltf", {begin, begin + text.size()}), "");
}

}  // namespace
}  // namespace polylume::scene::test
