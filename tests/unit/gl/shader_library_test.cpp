// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/shader_library.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "polylume/error.hpp"
#include "render/material_variant.hpp"

namespace polylume::gl {
namespace {

using ::testing::HasSubstr;

TEST(ShaderLibraryTest, includesEachFileOnce) {
    const ShaderSource source = ShaderLibrary().expand("passes/lighting.frag");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = source.text.find("float ltcCrossZ(", at)) != std::string::npos;
         ++at)
        ++count;
    EXPECT_EQ(count, 1u);
    EXPECT_EQ(source.text.find("#include \""), std::string::npos);
}

TEST(ShaderLibraryTest, definesFollowTheVersion) {
    const std::vector<std::string> defines = {"A", "B 2"};
    EXPECT_THAT(ShaderLibrary().expand("passes/accumulate.frag", defines).text,
                ::testing::StartsWith("#version 450 core\n#define A\n#define B 2\n"));
}

TEST(ShaderLibraryTest, missingFileIsNamed) {
    try {
        ShaderLibrary().expand("passes/none.frag");
        FAIL();
    } catch (const ShaderError& error) {
        EXPECT_THAT(error.what(), HasSubstr("passes/none.frag"));
    }
}

TEST(ShaderLibraryTest, missingIncludeNamesFileAndLine) {
    std::filesystem::create_directories("library_test/passes");
    std::ofstream("library_test/passes/a.frag") << "\n#include \"nowhere.glsl\"\n";
    try {
        ShaderLibrary("library_test").expand("passes/a.frag");
        FAIL();
    } catch (const ShaderError& error) {
        EXPECT_THAT(error.what(), HasSubstr("nowhere.glsl"));
        EXPECT_THAT(error.what(), HasSubstr("passes/a.frag:2"));
    }
}

TEST(ShaderLibraryTest, missingOverrideFolderIsAnError) {
    EXPECT_THROW(ShaderLibrary("no such folder"), Error);
}

TEST(ShaderLibraryTest, aGivenFileTakesTheOthersPlaceUnderItsOwnName) {
    ShaderLibrary library;
    library.setFile("surface/read_surface.glsl", "first line\n", "given");
    library.setFile("surface/read_surface.glsl", "second line\n#include \"nowhere.glsl\"\n",
                    "given");
    library.setFile("nowhere.glsl", "// found\n", "other");
    const ShaderSource source = library.expand("passes/lighting.frag");
    EXPECT_EQ(source.text.find("first line"), std::string::npos);
    EXPECT_EQ(source.text.find("readGBuffer(ivec2"), std::string::npos);
    EXPECT_NE(source.text.find("second line"), std::string::npos);
    const auto given = std::ranges::find(source.files, "given");
    ASSERT_NE(given, source.files.end());
    const auto place = std::to_string((given - source.files.begin()) * 100'000 + 7);
    EXPECT_EQ(nameFiles("0:" + place + "(2): error: x", source.files), "given:7(2): error: x\n");
    EXPECT_NE(ShaderLibrary().expand("passes/lighting.frag").text.find("readGBuffer(ivec2"),
              std::string::npos)
        << "another library has its own";
}

TEST(ShaderLibraryTest, extensionsComeFirst) {
    ShaderLibrary library;
    library.setFile("a.glsl", "int one;\n  # extension GL_A : enable\nint three;\n", "given");
    const std::vector<std::string> defines = {"B"};
    EXPECT_EQ(library.expand("a.glsl", defines).text,
              "#version 450 core\n#line 2\n  # extension GL_A : enable\n#define B\n#line 1\n"
              "int one;\n\nint three;\n");
}

TEST(ShaderLibraryTest, linesOfCommentsAreEmptied) {
    ShaderLibrary library;
    library.setFile("a.glsl", "// one\nint two;  // three\n  /// four\n/* five\n// six */ int a;\n",
                    "given");
    EXPECT_EQ(library.expand("a.glsl").text,
              "#version 450 core\n#line 1\n\nint two;  // three\n\n/* five\n// six */ int a;\n");
    // A line that goes on in the next one makes that a comment, too.
    library.setFile("a.glsl", "// one \\\nint two;\n", "given");
    EXPECT_EQ(library.expand("a.glsl").text, "#version 450 core\n#line 1\n// one \\\nint two;\n");
}

TEST(NameFilesTest, understandsTheLogsOfSeveralCompilers) {
    const std::vector<std::string> files = {"a.frag", "b.glsl"};
    EXPECT_EQ(nameFiles("0:100012(5): error: x", files), "b.glsl:12(5): error: x\n");
    EXPECT_EQ(nameFiles("0(7) : error C0000: x", files), "a.frag(7) : error C0000: x\n");
    EXPECT_EQ(nameFiles("ERROR: 0:100003: 'x'", files), "ERROR: b.glsl:3: 'x'\n");
    EXPECT_EQ(nameFiles("0:900001(1): error", files), "0:900001(1): error\n");
}

/// Runs the reference compiler over one expanded stage; its log where it rejects it.
std::string validate(const std::string& path, const std::vector<std::string>& defines) {
    const std::string stage = path.substr(path.rfind('.') + 1);
    // Tests run side by side, each in a process of its own.
    const std::string name = "validated_" + std::to_string(::getpid());
    const std::string file = name + "." + stage;
    std::ofstream(file) << ShaderLibrary().expand(path, defines).text;
    const std::string command =
        "glslangValidator -S " + stage + " " + file + " > " + name + ".log 2>&1";
    if (std::system(command.c_str()) == 0) return "";
    std::ifstream log(name + ".log");
    return {std::istreambuf_iterator<char>(log), {}};
}

TEST(GlslValidationTest, everyEntryPointIsValid) {
    std::vector<std::string> paths;
    for (const char* stage : {".frag", ".vert", ".comp"}) {
        const std::vector<std::string> ofStage = ShaderLibrary::paths(stage);
        EXPECT_FALSE(ofStage.empty()) << stage;
        paths.insert(paths.end(), ofStage.begin(), ofStage.end());
    }
    for (const std::string& path : paths) EXPECT_EQ(validate(path, {}), "") << path;
}

const std::vector<std::string> kLightDefines = {"POLYLUME_PARALLELOGRAM_LIGHTS",
                                                "POLYLUME_TRIANGLE_LIGHTS",
                                                "POLYLUME_POLYGON_LIGHTS",
                                                "POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS",
                                                "POLYLUME_TEXTURED_POLYGON_LIGHTS",
                                                "POLYLUME_DISK_LIGHTS",
                                                "POLYLUME_ELLIPSE_LIGHTS",
                                                "POLYLUME_SPHERE_LIGHTS",
                                                "POLYLUME_TUBE_LIGHTS",
                                                "POLYLUME_PUNCTUAL_LIGHTS"};

TEST(GlslValidationTest, everyLightVariantIsValid) {
    for (const std::string& lights : kLightDefines) {
        EXPECT_EQ(validate("passes/lighting.frag", {lights}), "") << lights;
    }
    EXPECT_EQ(validate("passes/lighting.frag", kLightDefines), "");
}

TEST(GlslValidationTest, everyComputeVariantIsValid) {
    for (const char* format : {"rgba32f", "rgba16f", "r11f_g11f_b10f", "rgba16", "rgba8"}) {
        std::vector<std::string> defines = kLightDefines;
        defines.push_back(std::string("POLYLUME_TARGET_FORMAT ") + format);
        EXPECT_EQ(validate("passes/lighting.comp", defines), "") << format;
        defines.insert(defines.end(), {"POLYLUME_ADD", "POLYLUME_HOST_SURFACE", "POLYLUME_SHEEN"});
        EXPECT_EQ(validate("passes/lighting.comp", defines), "") << format;
    }
    EXPECT_EQ(validate("passes/lighting.frag", {"POLYLUME_HOST_SURFACE"}), "");
}

TEST(GlslValidationTest, everyVariantOfListsIsValid) {
    for (const std::string& lights : kLightDefines) {
        EXPECT_EQ(validate("passes/lighting.frag", {"POLYLUME_LIGHT_LISTS", lights}), "") << lights;
    }
    std::vector<std::string> defines = kLightDefines;
    defines.insert(defines.end(), {"POLYLUME_LIGHT_LISTS", "POLYLUME_HOST_SURFACE",
                                   "POLYLUME_TWO_LOBES", "POLYLUME_SHEEN"});
    EXPECT_EQ(validate("passes/lighting.frag", defines), "");
    EXPECT_EQ(validate("passes/lighting.comp", defines), "");
    for (const char* define : {"POLYLUME_HOST_SURFACE", "POLYLUME_TWO_LOBES", "POLYLUME_SHEEN",
                               "POLYLUME_DIFFUSE_BURLEY", "POLYLUME_DIFFUSE_OREN_NAYAR"}) {
        EXPECT_EQ(validate("passes/tile_bounds.comp", {define}), "") << define;
    }
}

TEST(GlslValidationTest, everyModelVariantIsValid) {
    const std::vector<std::string> all = {
        "POLYLUME_TWO_LOBES",      "POLYLUME_SPECULAR_BECKMANN",
        "POLYLUME_DIFFUSE_BURLEY", "POLYLUME_DIFFUSE_OREN_NAYAR",
        "POLYLUME_SHEEN",
    };
    for (const std::string& define : all) {
        EXPECT_EQ(validate("passes/lighting.frag", {define}), "") << define;
        for (const std::string& lights : kLightDefines) {
            EXPECT_EQ(validate("passes/lighting.frag", {define, lights}), "") << define << lights;
        }
        EXPECT_EQ(validate("passes/blend.frag", {define}), "") << define;
    }
    for (const char* path :
         {"passes/gbuffer.frag", "passes/emitter.frag", "passes/emitter_solid.frag"}) {
        EXPECT_EQ(validate(path, {"POLYLUME_SHEEN"}), "") << path;
    }
    for (const std::string& diffuse : {all[2], all[3]}) {
        EXPECT_EQ(validate("passes/lighting.frag",
                           {all[0], all[1], diffuse, all[4], "POLYLUME_POLYGON_LIGHTS",
                            "POLYLUME_PUNCTUAL_LIGHTS"}),
                  "");
    }
}

TEST(GlslValidationTest, everyVariantWithLightListsIsValid) {
    const std::vector<std::vector<std::string>> models = {
        {},
        {"POLYLUME_TWO_LOBES"},
        {"POLYLUME_DIFFUSE_BURLEY"},
        {"POLYLUME_TWO_LOBES", "POLYLUME_DIFFUSE_OREN_NAYAR", "POLYLUME_SHEEN"},
        {"POLYLUME_HOST_SURFACE"}};
    for (const std::vector<std::string>& model : models) {
        EXPECT_EQ(validate("passes/tile_bounds.comp", model), "");
        std::vector<std::string> defines = model;
        defines.emplace_back("POLYLUME_LIGHT_LISTS");
        EXPECT_EQ(validate("passes/lighting.frag", defines), "");
        defines.insert(defines.end(), kLightDefines.begin(), kLightDefines.end());
        EXPECT_EQ(validate("passes/lighting.frag", defines), "");
        defines.emplace_back("POLYLUME_TARGET_FORMAT rgba32f");
        EXPECT_EQ(validate("passes/lighting.comp", defines), "");
    }
}

TEST(GlslValidationTest, everyMaterialSlotIsValid) {
    for (unsigned bit = 0; bit <= shared::kMaterialSlotCount; ++bit) {
        EXPECT_EQ(validate("passes/gbuffer.frag", variantDefines(1u << bit)), "") << bit;
    }
    EXPECT_EQ(validate("passes/gbuffer.frag", variantDefines(0x3FF)), "");
    EXPECT_EQ(validate("passes/blend.frag", variantDefines(0x1FF)), "");
    std::vector<std::string> defines = variantDefines(0x1FF);
    defines.insert(defines.end(), {"POLYLUME_POLYGON_LIGHTS", "POLYLUME_PUNCTUAL_LIGHTS"});
    EXPECT_EQ(validate("passes/blend.frag", defines), "");
}

TEST(GlslValidationTest, brokenShaderIsRejected) {
    EXPECT_NE(validate("passes/lighting.frag", {"vec3 nonsense"}), "");
}

}  // namespace
}  // namespace polylume::gl
