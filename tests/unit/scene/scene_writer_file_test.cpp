// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// What the written file says of buffers, images and pictures of lights.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "core/file.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "scene/light_image_reader.hpp"
#include "unit/scene/polylume_light_files.hpp"
#include "unit/scene/scene_writer_support.hpp"

namespace polylume::scene::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSamples = fs::path(POLYLUME_SOURCE_DIR) / "samples";

struct Glb {
    json document;
    std::string binary;
};

Glb readGlb(const fs::path& path) {
    const std::string file = readTextFile(path);
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, sizeof(value));
        return value;
    };
    EXPECT_EQ(number(8), file.size());
    const std::uint32_t jsonSize = number(12);
    Glb glb{json::parse(file.substr(20, jsonSize)), ""};
    if (file.size() > 20 + jsonSize) {
        EXPECT_EQ((20 + jsonSize) % 4, 0u);
        glb.binary = file.substr(28 + jsonSize, number(20 + jsonSize));
    }
    return glb;
}

/// A rectangle with a picture on it.
AreaLight pictured(const std::shared_ptr<const LightImage>& image, TextureWrap wrap) {
    PolygonLight light = makeRectangle({}, {2.0f, 1.0f}, glm::vec3(500.0f));
    light.texture = LightTexture{
        image, {1.0f, 0.5f, 0.0f}, {-2.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, wrap, wrap};
    return {"pictured", light, ""};
}

std::shared_ptr<LightImage> codedImage(int width, int height) {
    auto image = std::make_shared<LightImage>();
    image->size = {width, height};
    for (int i = 0; i < width * height; ++i) {
        const auto code = [&](int k) {
            return linearFromSrgb(static_cast<float>((i * 37 + k * 11) % 256) / 255.0f);
        };
        image->texels.emplace_back(code(0), code(1), code(2));
    }
    return image;
}

TEST(SceneWriterFileTest, keepsTheBytesOfBuffers) {
    const fs::path source = kSamples / "scenes/gallery.glb";
    const fs::path folder = freshFolder("bytes");
    const Glb before = readGlb(source);
    const SceneEdits edits = editsOf(readGltf(source));
    writeEditedScene(source, edits, folder / "gallery.glb");
    const Glb after = readGlb(folder / "gallery.glb");
    EXPECT_EQ(after.binary, before.binary);
    EXPECT_EQ(after.document["accessors"], before.document["accessors"]);
    EXPECT_EQ(after.document["bufferViews"], before.document["bufferViews"]);
    // To a .gltf and back.
    writeEditedScene(source, edits, folder / "gallery.gltf");
    EXPECT_EQ(readTextFile(folder / "gallery.bin").substr(0, before.binary.size()),
              before.binary.substr(0, fs::file_size(folder / "gallery.bin")));
    writeEditedScene(folder / "gallery.gltf", edits, folder / "back.glb");
    EXPECT_EQ(readGlb(folder / "back.glb").binary, before.binary);
    // Saved once more, there is no second .bin.
    writeEditedScene(source, edits, folder / "gallery.gltf");
    EXPECT_FALSE(fs::exists(folder / "gallery-1.bin"));
}

TEST(SceneWriterFileTest, neverTakesTheNameOfAnotherFile) {
    const fs::path folder = freshFolder("names");
    std::ofstream(folder / "gallery.bin") << "somebody else's";
    const fs::path source = kSamples / "scenes/gallery.glb";
    const Scene scene = readGltf(source);
    writeEditedScene(source, editsOf(scene), folder / "gallery.gltf");
    EXPECT_EQ(readTextFile(folder / "gallery.bin"), "somebody else's");
    EXPECT_TRUE(fs::exists(folder / "gallery-1.bin"));
    expectSameSurfaces(readGltf(folder / "gallery.gltf"), scene);
}

/// A file in a folder of an odd name whose buffer and image are files.
fs::path spreadFile(const std::string& name) {
    GltfBuilder builder;
    builder.addTriangle({{"material", 0}});
    builder.add("images", {{"uri", "pictures/r%C3%B6d%20%231.png"}});
    builder.add("textures", {{"source", 0}});
    builder.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    json document = json::parse(builder.text());
    document["buffers"][0]["uri"] = "data%20file.bin";
    const fs::path folder = freshFolder(name) / "a folder";
    fs::create_directories(folder / "pictures");
    writeFile(folder /
                  "pictures/r\xC3\xB6"
                  "d #1.png",
              pngBytes());
    writeFile(folder / "data file.bin", builder.buffer);
    std::ofstream(folder / "spread.gltf") << document.dump();
    return folder / "spread.gltf";
}

TEST(SceneWriterFileTest, urisLeadToTheSameFilesFromElsewhere) {
    const fs::path source = spreadFile("elsewhere");
    const Scene scene = readGltf(source);
    const fs::path away = source.parent_path().parent_path() / "away" / "deep";
    fs::create_directories(away);
    writeEditedScene(source, {}, away / "moved.gltf");
    expectSameSurfaces(readGltf(away / "moved.gltf"), scene);
    const json document = json::parse(readTextFile(away / "moved.gltf"));
    EXPECT_EQ(document["buffers"][0]["uri"], "../../a%20folder/data%20file.bin");
    // In its own folder a URI stays letter by letter.
    writeEditedScene(source, {}, source.parent_path() / "beside.gltf");
    EXPECT_EQ(json::parse(readTextFile(source.parent_path() / "beside.gltf"))["images"][0]["uri"],
              "pictures/r%C3%B6d%20%231.png");
}

TEST(SceneWriterFileTest, aGlbHoldsAll) {
    const fs::path source = spreadFile("whole");
    const Scene scene = readGltf(source);
    const fs::path target = source.parent_path().parent_path() / "whole.glb";
    writeEditedScene(source, {}, target);
    fs::remove_all(source.parent_path());
    expectSameSurfaces(readGltf(target), scene);
    const Glb glb = readGlb(target);
    EXPECT_EQ(glb.document["images"][0]["mimeType"], "image/png");
    EXPECT_EQ(glb.document.dump().find("\"uri\""), std::string::npos);
}

TEST(SceneWriterFileTest, aGlbRefersToAnImageThatIsMissing) {
    const fs::path source = spreadFile("missing");
    fs::remove_all(source.parent_path() / "pictures");
    const WarningLog log;
    writeEditedScene(source, {}, source.parent_path() / "missing.glb");
    ASSERT_EQ(log.messages.size(), 1u);
    EXPECT_THAT(log.messages[0], testing::HasSubstr("images[0]"));
}

TEST(SceneWriterFileTest, picturesOfTheSourceStayReferences) {
    const fs::path source = kSamples / "POLYLUME_lights_area/every_shape.gltf";
    const Scene scene = readGltf(source);
    SceneEdits edits = editsOf(scene);
    // Changed, so that they are written anew.
    for (AreaLight& area : edits.areaLights) {
        std::visit([](auto& shape) { shape.radiance *= 0.5f; }, area.shape);
    }
    const fs::path target = freshFolder("references") / "changed.gltf";
    writeEditedScene(source, edits, target);
    EXPECT_LT(lightDifference(readGltf(target), edits), 1e-6);
    const json before = json::parse(readTextFile(source));
    const json after = json::parse(readTextFile(target));
    EXPECT_EQ(after["images"].size(), before["images"].size());
    EXPECT_EQ(after["textures"].size(), before["textures"].size());
}

TEST(SceneWriterFileTest, newPicturesAreEmbeddedOncePerPicture) {
    GltfBuilder builder;
    builder.addTriangle();
    const fs::path folder = freshFolder("embedded");
    std::ofstream(folder / "plain.gltf") << builder.text();
    const auto image = codedImage(5, 3);
    SceneEdits edits;
    edits.areaLights = {pictured(image, TextureWrap::clampToEdge),
                        pictured(image, TextureWrap::repeat)};
    edits.areaLights[1].name = "second";
    for (const char* name : {"embedded.gltf", "embedded.glb"}) {
        writeEditedScene(folder / "plain.gltf", edits, folder / name);
        EXPECT_EQ(lightDifference(readGltf(folder / name), edits), 0.0) << name;
    }
    const json document = json::parse(readTextFile(folder / "embedded.gltf"));
    EXPECT_EQ(document["images"].size(), 1u);
    EXPECT_EQ(document["textures"].size(), 2u);
    EXPECT_EQ(readGlb(folder / "embedded.glb").document.dump().find("\"uri\""), std::string::npos);
}

TEST(SceneWriterFileTest, picturesBeyondAPngLieBesideAsOpenExr) {
    GltfBuilder builder;
    builder.addTriangle();
    const fs::path folder = freshFolder("exr");
    std::ofstream(folder / "plain.gltf") << builder.text();
    const auto image = codedImage(4, 4);
    image->texels[5] = {7.5f, 0.1234f, 0.0f};
    SceneEdits edits;
    edits.areaLights = {pictured(image, TextureWrap::clampToEdge)};
    for (const char* name : {"bright.glb", "bright.gltf", "bright.glb"}) {
        writeEditedScene(folder / "plain.gltf", edits, folder / name);
        EXPECT_EQ(lightDifference(readGltf(folder / name), edits), 0.0) << name;
    }
    EXPECT_TRUE(fs::exists(folder / "bright-light-1.exr"));
    EXPECT_FALSE(fs::exists(folder / "bright-light-2.exr"));
    // Known by reference from then on, from another folder, too.
    edits.areaLights[0].name = "renamed";
    fs::create_directories(folder / "away");
    writeEditedScene(folder / "bright.glb", edits, folder / "away/moved.glb");
    EXPECT_EQ(lightDifference(readGltf(folder / "away/moved.glb"), edits), 0.0);
    EXPECT_FALSE(fs::exists(folder / "away/moved-light-1.exr"));
}

TEST(SceneWriterFileTest, valuesBetweenThoseOfAPngAreKept) {
    GltfBuilder builder;
    builder.addTriangle();
    const fs::path folder = freshFolder("between");
    std::ofstream(folder / "plain.gltf") << builder.text();
    const auto image = codedImage(2, 2);
    image->texels[3].y = 0.1234f;
    SceneEdits edits;
    edits.areaLights = {pictured(image, TextureWrap::clampToEdge)};
    writeEditedScene(folder / "plain.gltf", edits, folder / "between.glb");
    EXPECT_EQ(lightDifference(readGltf(folder / "between.glb"), edits), 0.0);
}

TEST(SceneWriterFileTest, aGlbMakesOneBufferOfMany) {
    GltfBuilder builder;
    builder.addTriangle();
    json document = json::parse(builder.text());
    // The first of two is shorter than a word, and in front of the one that is used.
    const json used = document["buffers"][0];
    document["buffers"] = json::array({{{"byteLength", 3}, {"uri", "data:;base64,AQID"}}, used});
    for (json& view : document["bufferViews"]) view["buffer"] = 1;
    const fs::path folder = freshFolder("many");
    std::ofstream(folder / "many.gltf") << document.dump();
    const Scene scene = readGltf(folder / "many.gltf");
    writeEditedScene(folder / "many.gltf", {}, folder / "one.glb");
    expectSameSurfaces(readGltf(folder / "one.glb"), scene);
    EXPECT_EQ(readGlb(folder / "one.glb").document["buffers"].size(), 1u);
    // A .gltf keeps them apart.
    writeEditedScene(folder / "many.gltf", {}, folder / "two.gltf");
    EXPECT_EQ(json::parse(readTextFile(folder / "two.gltf"))["buffers"], document["buffers"]);
}

TEST(SceneWriterFileTest, aPictureOnAPolygonKeepsItsPlace) {
    GltfBuilder builder =
        withLight({{"name", "sign"},
                   {"type", "polygon"},
                   {"texture", {{"index", 0}}},
                   {"polygon", {{"contours", kSquare}, {"texCoords", kSquareTexCoords}}}});
    addTexture(builder);
    const fs::path folder = freshFolder("plane");
    std::ofstream(folder / "sign.gltf") << builder.text();
    SceneEdits edits = editsOf(readGltf(folder / "sign.gltf"));
    auto& light = std::get<PolygonLight>(edits.areaLights.at(0).shape);
    // Skewed and turned, as no rectangle has it.
    light.contours[0].insert(light.contours[0].begin() + 1, {-1.5f, 0.0f, 0.0f});
    light.texture->axisU += glm::vec3(0.1f, 0.4f, 0.0f);
    writeEditedScene(folder / "sign.gltf", edits, folder / "skewed.gltf");
    EXPECT_LT(lightDifference(readGltf(folder / "skewed.gltf"), edits), 1e-6);
}

}  // namespace
}  // namespace polylume::scene::test
