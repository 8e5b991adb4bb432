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
    EXPECT_TRUE(loads(renderRoom(path("a.exr"))));
}

}  // namespace
}  // namespace polylume
