// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>

#include "command_fixture.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using test::sourcePath;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RenderTest : public test::CommandTest {
  protected:
    /// Renders the room and reads the picture.
    FloatImage renderAndRead(const std::string& name, const std::vector<std::string>& more = {}) {
        const Outcome outcome = runCommand(renderRoom(path(name), more));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return readImage(path(name));
    }

    /// Renders where that fails; the picture that was there before has to stay, and nothing else.
    std::string failToRender(const std::vector<std::string>& arguments,
                             const test::Surroundings& surroundings = {}) {
        const std::vector<std::string> before = files();
        const Outcome outcome = runCommand(arguments, surroundings);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        EXPECT_THAT(outcome.error, HasSubstr("error: "));
        EXPECT_EQ(files(), before);
        return outcome.error;
    }

    static std::string text(const FloatImage& image, const std::string& name) {
        const auto found = image.metadata.find(name);
        if (found == image.metadata.end()) return "(none)";
        const auto* value = std::get_if<std::string>(&found->second);
        return value == nullptr ? "(no text)" : *value;
    }

    static float largest(const FloatImage& image) {
        return *std::max_element(image.pixels.begin(), image.pixels.end());
    }
};

TEST_F(RenderTest, exrHoldsNits) {
    const FloatImage image = renderAndRead("a.exr");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 36);
    EXPECT_THAT(image.channelNames, ElementsAre("R", "G", "B", "A"));
    for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
    // The ceiling light is seen: 2200 nits of colour 1 in red, exposed and mapped by nothing.
    EXPECT_EQ(largest(image), 2200.0f);
}

TEST_F(RenderTest, bothBackendsGiveTheSameBits) {
    const FloatImage egl = renderAndRead("a.exr", {"--backend", "egl"});
    const FloatImage osmesa = renderAndRead("b.exr", {"--backend", "osmesa"});
    EXPECT_THAT(text(egl, "polylume:backend"), HasSubstr("EGL"));
    EXPECT_EQ(text(osmesa, "polylume:backend"), "OSMesa");
    EXPECT_EQ(egl.channelNames, osmesa.channelNames);
    if (text(egl, "polylume:renderer") != text(osmesa, "polylume:renderer")) {
        GTEST_SKIP() << "EGL runs on " << text(egl, "polylume:renderer");
    }
    EXPECT_TRUE(egl.pixels == osmesa.pixels);
    EXPECT_GT(largest(egl), 0.0f);
}

TEST_F(RenderTest, sameRunSameBytes) {
    renderAndRead("a.exr");
    const std::string first = readText("a.exr");
    renderAndRead("a.exr");
    EXPECT_TRUE(readText("a.exr") == first);
    EXPECT_THAT(files(), ElementsAre("a.exr"));
}

TEST_F(RenderTest, exrSaysHowItWasMade) {
    const FloatImage image = renderAndRead("a.exr", {"--backend", "osmesa"});
    EXPECT_THAT(text(image, "Software"), ::testing::StartsWith("Polylume "));
    EXPECT_THAT(text(image, "polylume:scene"), HasSubstr("cornell.glb"));
    EXPECT_EQ(text(image, "polylume:backend"), "OSMesa");
    EXPECT_THAT(text(image, "polylume:renderer"), ::testing::Not(HasSubstr("(no")));
    EXPECT_THAT(text(image, "polylume:table"), AllOf(HasSubstr("built-in"), HasSubstr("ggx")));
    EXPECT_EQ(text(image, "polylume:camera"), "front");
    EXPECT_EQ(std::get<int>(image.metadata.at("polylume:samples")), 1);
}

TEST_F(RenderTest, pngIsEightBitsOfTheRightSizeWithMetadata) {
    ASSERT_EQ(runCommand(renderRoom(path("a.png"))).exitCode, 0);
    const PixelImage image = decodeImage(readFile(path("a.png")), "a.png");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 36);
    EXPECT_EQ(image.channelCount, 3);
    EXPECT_EQ(image.bitsPerChannel, 8);
    const std::string bytes = readText("a.png");
    for (const char* key : {"Software", "polylume:scene", "polylume:backend", "polylume:renderer",
                            "polylume:table", "polylume:exposure"}) {
        EXPECT_THAT(bytes, HasSubstr(key));
    }
}

TEST_F(RenderTest, pngIsTheExrExposedAndEncoded) {
    const FloatImage linear = renderAndRead("a.exr");
    ASSERT_EQ(
        runCommand(renderRoom(path("a.png"), {"--exposure", "9", "--tonemap", "none"})).exitCode,
        0);
    const PixelImage picture = decodeImage(readFile(path("a.png")), "a.png");
    for (std::size_t i = 0; i < 64 * 36; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            // 1 / (1.2 * 2^9), then IEC 61966-2-1.
            const double value = std::min(linear.pixels[4 * i + c] / 614.4, 1.0);
            const double encoded =
                value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
            ASSERT_NEAR(picture.pixels[3 * i + c], 255.0 * encoded, 0.501);
        }
    }
}

TEST_F(RenderTest, backgroundNoneLeavesAlpha) {
    // A camera far off sees little of the room.
    writeText("far.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"camera": 0, "translation": [0, 0, 40]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}]})");
    const auto alphas = [&](const std::string& name, const std::string& background) {
        const Outcome outcome = runCommand({"render", path("far.gltf"), "-o", path(name), "--size",
                                            "8x8", "--background", background, "-q"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return readImage(path(name));
    };
    FloatImage image = alphas("a.exr", "none");
    EXPECT_EQ(*image.pixel(0, 0), 0.0f);
    EXPECT_EQ(image.pixel(0, 0)[3], 0.0f);
    image = alphas("a.exr", "5,0.5,2000");
    EXPECT_THAT(std::vector<float>(image.pixel(0, 0), image.pixel(0, 0) + 4),
                ElementsAre(5.0f, 0.5f, 2000.0f, 1.0f));
    EXPECT_EQ(alphas("a.png", "none").channelCount(), 4u);
    EXPECT_EQ(alphas("b.png", "0,0,0").channelCount(), 3u);
}

TEST_F(RenderTest, camerasGoByIndexAndByName) {
    const FloatImage byDefault = renderAndRead("a.exr");
    EXPECT_TRUE(renderAndRead("b.exr", {"--camera", "0"}).pixels == byDefault.pixels);
    EXPECT_TRUE(renderAndRead("c.exr", {"--camera", "front"}).pixels == byDefault.pixels);
    for (const char* camera : {"back", "1", "-1", "0x0"}) {
        EXPECT_THAT(failToRender(renderRoom(path("d.exr"), {std::string("--camera=") + camera})),
                    AllOf(HasSubstr("cornell.glb"), HasSubstr("0 \"front\""), HasSubstr(camera)))
            << camera;
    }
}

TEST_F(RenderTest, theShippedTableIsTheBuiltInOne) {
    const FloatImage builtIn = renderAndRead("a.exr");
    for (const char* table : {"tables/ggx.exr", "tables/ggx.f32"}) {
        const FloatImage shipped = renderAndRead("b.exr", {"--table", sourcePath(table)});
        EXPECT_TRUE(shipped.pixels == builtIn.pixels) << table;
        EXPECT_THAT(text(shipped, "polylume:table"), HasSubstr("ggx."));
    }
}

TEST_F(RenderTest, anotherTableGivesAnotherPicture) {
    // The twin: with half of the reflectance in every texel the picture has to differ.
    FloatImage table = readImage(sourcePath("tables/ggx.exr"));
    for (const char* name : {"albedo", "fresnel"}) {
        const auto channel = table.channelIndex(name);
        ASSERT_TRUE(channel) << name;
        for (std::size_t i = *channel; i < table.pixels.size(); i += table.channelCount()) {
            table.pixels[i] *= 0.5f;
        }
    }
    std::erase_if(table.metadata,
                  [](const auto& entry) { return !entry.first.starts_with("polylume:"); });
    writeExr(path("half.exr"), table, ExrPrecision::single);
    const FloatImage builtIn = renderAndRead("a.exr");
    EXPECT_FALSE(renderAndRead("b.exr", {"--table", path("half.exr")}).pixels == builtIn.pixels);
}

TEST_F(RenderTest, brokenTablesAreErrors) {
    writeText("broken.exr", "not an image");
    writeText("broken.f32", "not a table");
    renderAndRead("picture.exr");
    writeText("a.exr", "the old picture");
    EXPECT_THAT(failToRender(renderRoom(path("a.exr"), {"--table", path("broken.exr")})),
                HasSubstr("broken.exr"));
    EXPECT_THAT(failToRender(renderRoom(path("a.exr"), {"--table", path("broken.f32")})),
                HasSubstr("broken.f32"));
    EXPECT_THAT(failToRender(renderRoom(path("a.exr"), {"--table", path("missing.exr")})),
                HasSubstr("missing.exr"));
    // A picture is no table.
    EXPECT_THAT(failToRender(renderRoom(path("a.exr"), {"--table", path("picture.exr")})),
                AllOf(HasSubstr("picture.exr"), HasSubstr("storage"), HasSubstr("polylume fit")));
    EXPECT_EQ(readText("a.exr"), "the old picture");
}

TEST_F(RenderTest, missingScenesAreNamed) {
    writeText("a.exr", "the old picture");
    EXPECT_THAT(failToRender({"render", path("missing.glb"), "-o", path("a.exr")}),
                HasSubstr("missing.glb"));
    writeText("broken.gltf", "{\"asset\": ");
    EXPECT_THAT(failToRender({"render", path("broken.gltf"), "-o", path("a.exr")}),
                HasSubstr("broken.gltf"));
    EXPECT_EQ(readText("a.exr"), "the old picture");
}

TEST_F(RenderTest, aShaderErrorLeavesTheOldPicture) {
    writeText("a.exr", "the old picture");
    writeText("glsl/passes/lighting.frag", "this is no shader\n");
    EXPECT_THAT(failToRender(renderRoom(path("a.exr"), {"--glsl-dir", path("glsl")})),
                HasSubstr("passes/lighting.frag"));
    EXPECT_EQ(readText("a.exr"), "the old picture");
}

TEST_F(RenderTest, glslDirTakesThePlaceOfTheBuiltInShaders) {
    writeText("glsl/passes/lighting.frag",
              "layout(location = 0) out vec4 outRadiance;\n"
              "void main() { outRadiance = vec4(42.0, 0.0, 0.0, 1.0); }\n");
    const FloatImage image = renderAndRead("a.exr", {"--glsl-dir", path("glsl")});
    EXPECT_EQ(image.pixel(32, 18)[0], 42.0f);
}

TEST_F(RenderTest, aFullDiskLeavesTheOldPictureAndNoOther) {
    for (const char* name : {"a.exr", "a.png"}) {
        writeText(name, "the old picture");
        // Far below a picture of 64x36 pixels.
        EXPECT_THAT(
            failToRender(renderRoom(path(name)),
                         {.environment = {"MESA_SHADER_CACHE_DISABLE=true"}, .sizeLimit = 512}),
            HasSubstr(name));
        EXPECT_EQ(readText(name), "the old picture");
    }
}

TEST_F(RenderTest, aMissingOutputFolderIsNamed) {
    for (const char* name : {"none/a.exr", "none/a.png"}) {
        EXPECT_THAT(
            failToRender(renderRoom(path(name))),
            AllOf(HasSubstr(path(name)), HasSubstr("expected a folder"), HasSubstr("create it")));
    }
}

TEST_F(RenderTest, lightsComeFromAnotherFile) {
    // The room's own light, and a second one of ten times the luminance.
    writeText("lamp.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "extensionsUsed": ["EXT_lights_area"],
        "extensions": {"EXT_lights_area": {"lights": [{"type": "rect", "intensity": 22000.0}]}},
        "nodes": [{"extensions": {"EXT_lights_area": {"light": 0}}, "translation": [0, 1, 4]}]})");
    const FloatImage alone = renderAndRead("a.exr", {"--hide-lights"});
    const FloatImage both =
        renderAndRead("b.exr", {"--hide-lights", "--lights", path("lamp.gltf")});
    double sumAlone = 0.0;
    double sumBoth = 0.0;
    for (std::size_t i = 0; i < alone.pixels.size(); ++i) {
        // Light adds up, within float's rounding.
        ASSERT_GE(both.pixels[i], alone.pixels[i] * (1.0f - 1e-5f));
        sumAlone += alone.pixels[i];
        sumBoth += both.pixels[i];
    }
    EXPECT_GT(sumBoth, 1.5 * sumAlone);
    EXPECT_THAT(failToRender(renderRoom(path("c.exr"), {"--lights", path("missing.gltf")})),
                HasSubstr("missing.gltf"));
}

TEST_F(RenderTest, lobesAddUpAndLightsHide) {
    const FloatImage all = renderAndRead("a.exr", {"--hide-lights", "--aov", "emission"});
    const FloatImage diffuse = renderAndRead("b.exr", {"--lobes", "diffuse"});
    const FloatImage specular = renderAndRead("c.exr", {"--lobes", "specular"});
    const auto emission = all.channelIndex("emission.R");
    ASSERT_TRUE(emission);
    float brightest = 0.0f;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < 64 * 36; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float* whole = all.pixels.data() + i * all.channelCount();
            const float sum = diffuse.pixels[4 * i + c] + specular.pixels[4 * i + c];
            brightest = std::max(brightest, whole[c]);
            // Only where the camera sees the light: what is behind it shows in `all` alone.
            const float error = whole[c] - whole[*emission + c] - sum;
            differing += std::abs(error) > 1e-3f ? 1 : 0;
        }
    }
    EXPECT_LT(brightest, 2200.0f);
    EXPECT_LT(differing, 100u);
    EXPECT_GT(largest(diffuse), 10.0f);
    EXPECT_GT(largest(specular), 10.0f);
}

TEST_F(RenderTest, aovsAreLayers) {
    const FloatImage some = renderAndRead("a.exr", {"--aov", "depth,normal"});
    EXPECT_EQ(some.channelCount(), 8u);
    for (const char* name : {"R", "A", "depth.Z", "normal.X", "normal.Y", "normal.Z"}) {
        EXPECT_TRUE(some.channelIndex(name)) << name;
    }
    EXPECT_EQ(renderAndRead("a.exr", {"--aov", "all"}).channelCount(), 27u);
}

TEST_F(RenderTest, whatIsMissingIsMadeAndSaid) {
    // A triangle without camera and light: positions 0 0 0, 1 0 0, 0 1 0 in a data URI.
    writeText("bare.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri":
            "data:application/octet-stream;base64,)"
                           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
    const Outcome outcome =
        runCommand({"render", path("bare.gltf"), "-o", path("a.exr"), "--size", "32x32"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("no camera"), HasSubstr("no light")));
    EXPECT_GT(largest(readImage(path("a.exr"))), 10.0f) << "the picture shows nothing";
    EXPECT_THAT(
        failToRender({"render", path("bare.gltf"), "-o", path("a.exr"), "--camera", "front"}),
        HasSubstr("no camera"));
}

}  // namespace
}  // namespace polylume
