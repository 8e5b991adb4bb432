// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using test::Surroundings;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class InfoTest : public test::CommandTest {
  protected:
    /// Surroundings in which the dynamic linker finds files of the libraries' names that are none.
    Surroundings hide(const std::vector<std::string>& libraries) const {
        for (const std::string& library : libraries) writeText("hidden/" + library, "");
        return {.environment = {"LD_LIBRARY_PATH=" + path("hidden")}};
    }
};

const std::vector<std::string> kEglLibraries = {"libEGL.so.1"};
const std::vector<std::string> kOsmesaLibraries = {"libOSMesa.so.8", "libOSMesa.so.6",
                                                   "libOSMesa.so"};
const std::vector<std::string> kBothLibraries = {"libEGL.so.1", "libOSMesa.so.8", "libOSMesa.so.6",
                                                 "libOSMesa.so"};

/// A square metre that emits from both sides.
constexpr const char* kEmissivePanel = R"({
"asset": {"version": "2.0"},
"extensionsUsed": ["KHR_materials_emissive_strength"],
"scenes": [{"nodes": [0]}],
"nodes": [{"name": "lamp", "mesh": 0}],
"meshes": [{"name": "panel", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
"materials": [{"emissiveFactor": [0.5, 1, 1], "doubleSided": true,
               "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 500}}}],
"accessors": [
    {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
    {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
"buffers": [{"byteLength": 60,
    "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA"}]
})";

TEST_F(InfoTest, listsEveryWayWithWhatItGives) {
    const Outcome outcome = runCommand({"info"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("\nEGL "), HasSubstr("\nOSMesa\n")));
    for (const char* way : {"\nEGL ", "\nOSMesa\n"}) {
        // The part of this way ends at the next empty line.
        const std::size_t begin = outcome.output.find(way) + 1;
        const std::string part =
            outcome.output.substr(begin, outcome.output.find("\n\n", begin) - begin);
        EXPECT_THAT(
            part, AllOf(ContainsRegex("vendor +[^ ]"), ContainsRegex("renderer +[^ ]"),
                        ContainsRegex("version +4\\.[5-9]"), ContainsRegex("texture size +[0-9]")));
    }
}

TEST_F(InfoTest, saysWhyAWayIsNotToBeHad) {
    const Outcome withoutOsmesa = runCommand({"info"}, hide(kOsmesaLibraries));
    EXPECT_EQ(withoutOsmesa.exitCode, 0);
    EXPECT_THAT(withoutOsmesa.output, AllOf(ContainsRegex("OSMesa\n +not to be had +.*libOSMesa"),
                                            HasSubstr("renderer")));
}

TEST_F(InfoTest, endsWellWhereNothingWorks) {
    const Outcome outcome = runCommand({"info"}, hide(kBothLibraries));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output, AllOf(ContainsRegex("EGL\n +not to be had +.*libEGL"),
                                      ContainsRegex("OSMesa\n +not to be had +.*libOSMesa"),
                                      Not(HasSubstr("renderer"))));
}

TEST_F(InfoTest, renderWithoutAnyBackendListsEachAttempt) {
    const Outcome outcome = runCommand(renderRoom(path("a.exr")), hide(kBothLibraries));
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error,
                AllOf(HasSubstr("libEGL.so.1"), HasSubstr("libOSMesa"),
                      HasSubstr("apt-get install"), HasSubstr("libegl1"), HasSubstr("libosmesa6")));
    EXPECT_THAT(files(), ::testing::ElementsAre("hidden"));
}

TEST_F(InfoTest, renderNamesTheBackendThatWasAskedFor) {
    const Outcome osmesa =
        runCommand(renderRoom(path("a.exr"), {"--backend", "osmesa"}), hide(kOsmesaLibraries));
    EXPECT_EQ(osmesa.exitCode, 1);
    EXPECT_THAT(osmesa.error,
                AllOf(HasSubstr("libOSMesa"), HasSubstr("libosmesa6"), Not(HasSubstr("EGL"))));
    const Outcome egl =
        runCommand(renderRoom(path("b.exr"), {"--backend", "egl"}), hide(kEglLibraries));
    EXPECT_EQ(egl.exitCode, 1);
    EXPECT_THAT(egl.error,
                AllOf(HasSubstr("libEGL.so.1"), HasSubstr("libegl1"), Not(HasSubstr("osmesa6"))));
}

TEST_F(InfoTest, oneBackendIsEnough) {
    for (const auto& hidden : {kEglLibraries, kOsmesaLibraries}) {
        std::filesystem::remove_all(path("hidden"));
        const Outcome outcome = runCommand(renderRoom(path("a.exr")), hide(hidden));
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    }
}

TEST_F(InfoTest, listsTheLightsOfAScene) {
    const Outcome outcome =
        runCommand({"info", test::sourcePath("samples/POLYLUME_lights_area/every_shape.gltf")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.error, IsEmpty());
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("1 camera\n"), HasSubstr("5 area lights\n"),
                      ContainsRegex("\"panel\" +polygon of 4 vertices, 1.6 m2, texture 8x8, "
                                    "\\(3000, 3000, 3000\\) nits\n"),
                      ContainsRegex("\"star\" +polygon of 14 vertices with 1 hole, .*two-sided\n"),
                      ContainsRegex("\"softbox\" +ellipse 1.4 x 0.8 m at"),
                      ContainsRegex("\"globe\" +sphere of radius 0.3 m at"),
                      ContainsRegex("\"neon\" +tube 2 m long of radius 0.03 m")));
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("POLYLUME_lights_area.lights[4] \"neon\" at nodes[5]"),
                      HasSubstr("0 lights without extent"), Not(HasSubstr("OpenGL"))));
}

TEST_F(InfoTest, listsEmissiveLightsWhereTheyAreAskedFor) {
    writeText("panel.gltf", kEmissivePanel);
    const Outcome without = runCommand({"info", path("panel.gltf")});
    EXPECT_EQ(without.exitCode, 0) << without.error;
    EXPECT_THAT(without.output, HasSubstr("0 area lights"));
    const Outcome with = runCommand({"info", path("panel.gltf"), "--emissive-lights"});
    EXPECT_EQ(with.exitCode, 0) << with.error;
    EXPECT_THAT(with.output, AllOf(HasSubstr("1 area light\n"),
                                   ContainsRegex("\"lamp\" +polygon of 4 vertices, 1 m2, "
                                                 "\\(250, 500, 500\\) nits, two-sided")));
    EXPECT_THAT(with.error, HasSubstr("\"panel\" of 2 triangles: 1 polygon light"));
}

TEST_F(InfoTest, picturesTakeEmissiveLightsWhereTheyAreAskedFor) {
    writeText("panel.gltf", kEmissivePanel);
    for (const char* command : {"render", "reference"}) {
        std::vector<std::string> arguments = {command,       path("panel.gltf"), "-o",
                                              path("a.exr"), "--size",           "16x9"};
        if (command == std::string("reference")) {
            arguments.insert(arguments.end(), {"--spp", "64"});
        }
        const Outcome without = runCommand(arguments);
        EXPECT_EQ(without.exitCode, 0) << without.error;
        EXPECT_THAT(without.error, HasSubstr("has no light: lit it"));
        arguments.emplace_back("--emissive-lights");
        const Outcome with = runCommand(arguments);
        EXPECT_EQ(with.exitCode, 0) << with.error;
        EXPECT_THAT(with.error,
                    AllOf(HasSubstr("1 polygon light"), Not(HasSubstr("has no light"))));
    }
}

TEST_F(InfoTest, saysWhyASceneCanNotBeRead) {
    const Outcome missing = runCommand({"info", path("missing.gltf")});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.error, HasSubstr("missing.gltf"));
    const Outcome usage = runCommand({"info", "--emissive-lights"});
    EXPECT_EQ(usage.exitCode, 2);
    EXPECT_THAT(usage.error, HasSubstr("scene"));
}

TEST_F(InfoTest, imagesAloneLoadOpenImageIo) {
    // glibc's dynamic linker reports each library that it opens, on standard error.
    const Surroundings traced{.environment = {"LD_DEBUG=files"}};
    const auto loads = [&](const std::vector<std::string>& arguments) {
        const Outcome outcome = runCommand(arguments, traced);
        EXPECT_THAT(outcome.error, HasSubstr("libc.so.6")) << "the linker reports nothing";
        return outcome.error.find("OpenImageIO") != std::string::npos;
    };
    EXPECT_FALSE(loads({"--help"}));
    EXPECT_FALSE(loads({"render", "--help"}));
    EXPECT_FALSE(loads({"info"}));
    EXPECT_FALSE(loads({"fit", "--brdf", "nonsense", "-o", path("a.exr")}));
    EXPECT_FALSE(loads(renderRoom(path("a.png"))));
    EXPECT_TRUE(loads(renderRoom(path("a.exr"))));
}

}  // namespace
}  // namespace polylume
