// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class UsageTest : public test::CommandTest {
  protected:
    /// Bad usage: exit code 2, nothing on standard output, nothing written.
    std::string reject(const std::vector<std::string>& arguments) {
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        EXPECT_THAT(files(), IsEmpty());
        return outcome.error;
    }
    std::string rejectRender(const std::string& output, const std::vector<std::string>& more) {
        return rejectPicture("render", output, more);
    }
    std::string rejectReference(const std::string& output, const std::vector<std::string>& more) {
        return rejectPicture("reference", output, more);
    }

  private:
    std::string rejectPicture(const std::string& command, const std::string& output,
                              const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {
            command, test::sourcePath("samples/scenes/cornell.glb"), "-o", path(output)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return reject(arguments);
    }
};

TEST_F(UsageTest, helpListsTheCommands) {
    const Outcome outcome = runCommand({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.error, IsEmpty());
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("render"), HasSubstr("reference"), HasSubstr("info"),
                      HasSubstr("fit"), HasSubstr("table"), HasSubstr("--verbose"),
                      HasSubstr("--quiet"), HasSubstr("Exit codes")));
}

TEST_F(UsageTest, helpOfEachCommandShowsExamples) {
    const Outcome render = runCommand({"render", "--help"});
    EXPECT_EQ(render.exitCode, 0);
    EXPECT_THAT(render.output, AllOf(HasSubstr("Examples:"), HasSubstr("polylume render ")));
    for (const char* flag :
         {"--output", "--size", "--backend", "--camera", "--samples", "--exposure", "--tonemap",
          "--lobes", "--table", "--lights", "--aov", "--background", "--two-sided", "--hide-lights",
          "--emissive-lights", "--glsl-dir"}) {
        EXPECT_THAT(render.output, HasSubstr(flag));
    }
    const Outcome reference = runCommand({"reference", "--help"});
    EXPECT_EQ(reference.exitCode, 0);
    EXPECT_THAT(reference.output, AllOf(HasSubstr("Examples:"), HasSubstr("polylume reference "),
                                        HasSubstr("standardError"), HasSubstr("partial")));
    for (const char* flag :
         {"--output", "--size", "--camera", "--samples", "--exposure", "--tonemap", "--lobes",
          "--lights", "--aov", "--background", "--spp", "--target-error", "--threads", "--seed",
          "--shadows", "--depth", "--resume", "--emissive-lights"}) {
        EXPECT_THAT(reference.output, HasSubstr(flag));
    }
    const Outcome fit = runCommand({"fit", "--help"});
    EXPECT_EQ(fit.exitCode, 0);
    EXPECT_THAT(fit.output, AllOf(HasSubstr("Examples:"), HasSubstr("polylume fit --brdf ggx"),
                                  HasSubstr("oren-nayar"), HasSubstr("merl:FILE")));
    EXPECT_EQ(runCommand({"info", "--help"}).exitCode, 0);
}

TEST_F(UsageTest, versionIsPrinted) {
    const Outcome outcome = runCommand({"--version"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output, ::testing::MatchesRegex("polylume [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(UsageTest, aCommandIsRequired) {
    EXPECT_THAT(reject({}), HasSubstr("subcommand"));
    EXPECT_THAT(reject({"paint"}), HasSubstr("paint"));
}

TEST_F(UsageTest, unknownFlagsAreNamed) {
    EXPECT_THAT(rejectRender("a.exr", {"--sparkle"}), HasSubstr("--sparkle"));
    EXPECT_THAT(reject({"info", "--sparkle"}), HasSubstr("--sparkle"));
}

TEST_F(UsageTest, sceneAndOutputAreRequired) {
    EXPECT_THAT(reject({"render", "-o", path("a.exr")}), HasSubstr("scene"));
    EXPECT_THAT(reject({"render", "scene.glb"}), HasSubstr("--output"));
}

TEST_F(UsageTest, sizesAreChecked) {
    for (const char* size : {"banana", "640", "640x", "x480", "0x480", "640x-1", "640x480x2",
                             "64.5x10", "99999999999x1", ""}) {
        EXPECT_THAT(rejectRender("a.exr", {"--size", size}),
                    AllOf(HasSubstr("--size"), HasSubstr("1280x720"), HasSubstr(size)))
            << size;
    }
}

TEST_F(UsageTest, sampleCountsAreChecked) {
    for (const char* count : {"-1", "0", "many", "1.5"}) {
        EXPECT_THAT(rejectRender("a.exr", {"--samples", count}),
                    AllOf(HasSubstr("--samples"), HasSubstr(count)))
            << count;
    }
}

TEST_F(UsageTest, outputFormatsAreChecked) {
    for (const char* name : {"a.jpg", "a", "a.exr.bak", "a.EXR.txt"}) {
        EXPECT_THAT(rejectRender(name, {}), AllOf(HasSubstr("--output"), HasSubstr(".exr"),
                                                  HasSubstr(".png"), HasSubstr(name)));
    }
}

TEST_F(UsageTest, aPngHasNoLayers) {
    EXPECT_THAT(rejectRender("a.png", {"--aov", "normal"}),
                AllOf(HasSubstr("--aov"), HasSubstr(".exr")));
}

TEST_F(UsageTest, unknownNamesListTheKnownOnes) {
    EXPECT_THAT(rejectRender("a.exr", {"--aov", "normal,gloss"}),
                AllOf(HasSubstr("gloss"), HasSubstr("position"), HasSubstr("roughness")));
    EXPECT_THAT(rejectRender("a.exr", {"--backend", "glx"}),
                AllOf(HasSubstr("auto|egl|osmesa"), HasSubstr("glx")));
    EXPECT_THAT(rejectRender("a.exr", {"--lobes", "both"}),
                AllOf(HasSubstr("diffuse|specular|all"), HasSubstr("both")));
    EXPECT_THAT(rejectRender("a.png", {"--tonemap", "filmic"}),
                AllOf(HasSubstr("none|reinhard|aces|neutral"), HasSubstr("filmic")));
}

TEST_F(UsageTest, numbersAreChecked) {
    for (const char* ev : {"bright", "nan", "inf", "1e9", "3,5"}) {
        EXPECT_THAT(rejectRender("a.png", {"--exposure", ev}),
                    AllOf(HasSubstr("--exposure"), HasSubstr("auto"), HasSubstr(ev)))
            << ev;
    }
    for (const char* color : {"1", "1,2", "1,2,3,4", "-1,0,0", "nan,0,0", "red", "1, 2,x"}) {
        EXPECT_THAT(rejectRender("a.exr", {std::string("--background=") + color}),
                    AllOf(HasSubstr("--background"), HasSubstr("none"), HasSubstr(color)))
            << color;
    }
}

TEST_F(UsageTest, flagsOfTheReferenceAreChecked) {
    const std::pair<const char*, std::vector<const char*>> cases[] = {
        {"--spp", {"0", "-1", "many", "1.5", "99999999999"}},
        {"--target-error", {"0", "1", "-0.1", "nan", "1%"}},
        {"--threads", {"-1", "many"}},
        {"--seed", {"-1", "4294967296", "1.5", "x"}},
        {"--shadows", {"maybe", "1"}},
        {"--depth", {"0", "-1", "65", "deep"}}};
    for (const auto& [flag, values] : cases) {
        for (const char* value : values) {
            const std::string argument = std::string(flag) + "=" + value;
            EXPECT_THAT(rejectReference("a.exr", {argument}),
                        AllOf(HasSubstr(flag), HasSubstr(value)))
                << argument;
        }
    }
    EXPECT_THAT(rejectReference("a.exr", {"--shadows", "off", "--depth", "2"}),
                AllOf(HasSubstr("--depth"), HasSubstr("--shadows off"), HasSubstr("\"2\"")));
    EXPECT_THAT(rejectReference("a.jpg", {}), AllOf(HasSubstr(".exr"), HasSubstr("a.jpg")));
    EXPECT_THAT(rejectReference("a.png", {"--aov", "normal"}), HasSubstr("--aov"));
    EXPECT_THAT(reject({"reference", "-o", path("a.exr")}), HasSubstr("scene"));
}

TEST_F(UsageTest, theReferenceHasNoFlagsOfOpenGlAndTables) {
    for (const char* flag :
         {"--backend=egl", "--table=ggx.exr", "--quality=high", "--glsl-dir=."}) {
        EXPECT_THAT(rejectReference("a.exr", {flag}), HasSubstr(flag));
    }
}

TEST_F(UsageTest, quietAndVerboseExcludeEachOther) {
    EXPECT_THAT(rejectRender("a.exr", {"-q", "-v"}), HasSubstr("--verbose"));
}

}  // namespace
}  // namespace polylume
