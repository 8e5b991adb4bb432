// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <chrono>

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class FitTest : public test::CommandTest {};

TEST_F(FitTest, unknownBrdfsListTheKnownOnes) {
    const Outcome outcome = runCommand({"fit", "--brdf", "nonsense", "-o", path("a.exr")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("nonsense"), HasSubstr("ggx")));
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(FitTest, aMissingFolderIsFoundBeforeTheFit) {
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = runCommand({"fit", "--brdf", "ggx", "-o", path("none/a.exr")});
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr(path("none/a.exr")), HasSubstr("folder")));
    // A fit takes many seconds; to find out takes none.
    EXPECT_LT(elapsed.count(), 2.0);
}

TEST_F(FitTest, otherFormatsAreBadUsage) {
    const Outcome outcome = runCommand({"fit", "--brdf", "ggx", "-o", path("a.png")});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("--output"), HasSubstr(".exr")));
    EXPECT_EQ(runCommand({"fit", "-o", path("a.exr")}).exitCode, 2);
    EXPECT_EQ(runCommand({"fit", "--brdf", "ggx"}).exitCode, 2);
    EXPECT_EQ(runCommand({"fit", "--brdf", "ggx", "-o", path("a.exr"), "--threads", "-2"}).exitCode,
              2);
}

TEST_F(FitTest, flagsAreChecked) {
    const auto reject = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = {"fit", "--brdf", "ggx", "-o", path("a.exr")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.error;
        EXPECT_THAT(files(), IsEmpty());
        return outcome.error;
    };
    EXPECT_THAT(reject({"--solver", "magic"}), AllOf(HasSubstr("lm|moments"), HasSubstr("magic")));
    EXPECT_THAT(reject({"--lobe-count", "3"}), HasSubstr("--lobe-count"));
    EXPECT_THAT(reject({"--size", "15"}), HasSubstr("--size"));
    EXPECT_THAT(reject({"--size", "257"}), HasSubstr("--size"));
    EXPECT_THAT(reject({"--view-only", "--roughness", "1.5"}), HasSubstr("--roughness"));
    EXPECT_THAT(reject({"--view-only", "--roughness", "nan"}), HasSubstr("--roughness"));
    EXPECT_THAT(reject({"--roughness", "0.5"}), HasSubstr("--view-only"));
}

TEST_F(FitTest, theSameBytesOnAnyNumberOfThreads) {
    const auto fit = [&](const std::string& name, const std::string& threads) {
        const Outcome outcome = runCommand({"fit", "--brdf", "ggx", "--solver", "moments", "--size",
                                            "16", "-o", path(name), "--threads", threads});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    };
    fit("one.exr", "1");
    fit("two.exr", "2");
    EXPECT_EQ(readText("one.exr"), readText("two.exr"));
    EXPECT_EQ(readText("one.f32"), readText("two.f32"));
}

TEST_F(FitTest, aColumnOverTheViewAngleAlone) {
    const Outcome outcome =
        runCommand({"fit", "--brdf", "ggx", "--solver", "moments", "--size", "16", "--view-only",
                    "--roughness", "0.7", "-o", path("a.exr")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    const Outcome info = runCommand({"table", "info", path("a.exr")});
    EXPECT_THAT(info.output, AllOf(HasSubstr("1x16 nodes"), HasSubstr("0.7")));
    EXPECT_EQ(runCommand({"table", "score", path("a.exr")}).exitCode, 0);
}

TEST_F(FitTest, aBadMerlFileLeavesTheOldTable) {
    writeText("paint.binary", "not a MERL file");
    writeText("a.exr", "old");
    const Outcome outcome =
        runCommand({"fit", "--brdf", "merl:" + path("paint.binary"), "-o", path("a.exr")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr(path("paint.binary")));
    EXPECT_EQ(readText("a.exr"), "old");
}

}  // namespace
}  // namespace polylume
