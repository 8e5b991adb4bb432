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

}  // namespace
}  // namespace polylume
