// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <filesystem>

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class TerminalTest : public test::CommandTest {
  protected:
    /// Runs for minutes where it is not stopped.
    std::vector<std::string> renderAtLength() const {
        return {"render",    test::sourcePath("samples/scenes/cornell.glb"),
                "-o",        path("a.exr"),
                "--size",    "64x36",
                "--samples", "65536"};
    }
};

TEST_F(TerminalTest, quietSaysNothing) {
    const Outcome outcome = runCommand(renderRoom(path("a.exr"), {"-q"}));
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output, IsEmpty());
    EXPECT_THAT(outcome.error, IsEmpty());
}

TEST_F(TerminalTest, quietStillNamesErrors) {
    const Outcome outcome = runCommand({"-q", "render", path("none.glb"), "-o", path("a.exr")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr("none.glb"));
}

TEST_F(TerminalTest, usuallyItSaysWhatItDid) {
    const Outcome outcome = runCommand(renderRoom(path("a.exr"), {"--backend", "osmesa"}));
    EXPECT_THAT(outcome.output, IsEmpty()) << "the log goes to standard error";
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("OSMesa"), HasSubstr("wrote " + path("a.exr"))));
    // Every line says who speaks.
    for (std::size_t at = 0; at < outcome.error.size(); at = outcome.error.find('\n', at) + 1) {
        EXPECT_EQ(outcome.error.compare(at, 10, "polylume: "), 0) << outcome.error.substr(at, 40);
    }
}

TEST_F(TerminalTest, verboseSaysMore) {
    // With a backend that is not to be had, the attempts are told.
    const std::vector<std::string> environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent"};
    const Outcome usual = runCommand(renderRoom(path("a.exr")), {.environment = environment});
    const Outcome verbose =
        runCommand(renderRoom(path("a.exr"), {"-v"}), {.environment = environment});
    EXPECT_EQ(verbose.exitCode, 0) << verbose.error;
    EXPECT_GT(verbose.error.size(), usual.error.size());
    EXPECT_THAT(verbose.error, HasSubstr("no context by EGL"));
    EXPECT_THAT(usual.error, Not(HasSubstr("no context by EGL")));
}

TEST_F(TerminalTest, aTerminalGetsAProgressBar) {
    if (!std::filesystem::exists("/dev/pts/ptmx")) {
        GTEST_SKIP() << "no pseudo-terminal is to be had: devpts is not mounted";
    }
    const Outcome outcome = runCommand(renderAtLength(), {.terminal = true, .stopText = "s left"});
    EXPECT_THAT(outcome.error, AllOf(HasSubstr("rendering ["), HasSubstr(" %, ")));
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(TerminalTest, aPipeGetsNone) {
    // The same run, longer than the bar's two seconds of patience.
    const Outcome outcome = runCommand(renderAtLength(), {.timeLimitSeconds = 4.0});
    EXPECT_EQ(outcome.exitCode, -1) << "it was to run until it is stopped";
    EXPECT_THAT(outcome.error,
                AllOf(Not(HasSubstr("rendering [")), Not(HasSubstr("\r")), Not(HasSubstr("\x1b"))));
}

}  // namespace
}  // namespace polylume
