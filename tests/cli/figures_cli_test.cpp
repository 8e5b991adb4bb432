// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <filesystem>

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class FiguresTest : public test::CommandTest {
  protected:
    Outcome run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "figures");
        return runCommand(arguments);
    }
    std::vector<std::string> filesOf(std::string_view folder) {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(path(folder))) {
            names.push_back(entry.path().filename().string());
        }
        std::ranges::sort(names);
        return names;
    }
};

TEST_F(FiguresTest, drawsOneFigureAndItsPageIntoANewFolder) {
    const std::string folder = path("new/figures");
    const Outcome outcome = run({"-o", folder, "--only", "jacobian", "--quick"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(folder + "/index.html"));
    EXPECT_THAT(filesOf("new/figures"), ElementsAre("index.html", "jacobian"));
    EXPECT_THAT(filesOf("new/figures/jacobian"), ElementsAre("deviation.png"));
    const std::string page = readText("new/figures/index.html");
    EXPECT_THAT(page, AllOf(HasSubstr("Jacobian"), HasSubstr("nearly singular"),
                            HasSubstr("data:image/png;base64,"), HasSubstr("</html>")));
    EXPECT_THAT(page, AllOf(Not(HasSubstr("http:")), Not(HasSubstr("https:"))));
}

TEST_F(FiguresTest, givesTheSameBytesAgainOnAnyThreads) {
    for (const char* threads : {"1", "2"}) {
        const std::string folder = path(threads);
        EXPECT_EQ(run({"-o", folder, "--only", "invariance", "--threads", threads}).exitCode, 0);
    }
    for (const char* name : {"index.html", "invariance/ltc.png", "invariance/densities.exr"}) {
        const std::string one = readText(std::string("1/") + name);
        EXPECT_FALSE(one.empty()) << name;
        EXPECT_TRUE(one == readText(std::string("2/") + name)) << name;
    }
}

TEST_F(FiguresTest, refusesAFigureThatItDoesNotKnow) {
    const Outcome outcome = run({"-o", path("out"), "--only", "flor"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.error,
                AllOf(HasSubstr("flor"), HasSubstr("floor"), HasSubstr("quality"),
                      HasSubstr("invariance"), HasSubstr("failures"), HasSubstr("jacobian")));
    EXPECT_THAT(files(), IsEmpty());
    EXPECT_EQ(run({}).exitCode, 2);
}

TEST_F(FiguresTest, refusesAFileInPlaceOfTheFolder) {
    writeText("taken", "old");
    const Outcome outcome = run({"-o", path("taken"), "--only", "jacobian", "--quick"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, AllOf(HasSubstr(path("taken")), HasSubstr("folder")));
    EXPECT_EQ(readText("taken"), "old");
}

TEST_F(FiguresTest, leavesTheOldPageWhereThereIsNoRoom) {
    writeText("out/index.html", "old");
    test::Surroundings small;
    small.sizeLimit = 1000;
    const Outcome outcome =
        runCommand({"figures", "-o", path("out"), "--only", "jacobian", "--quick"}, small);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(readText("out/index.html"), "old");
    EXPECT_THAT(filesOf("out/jacobian"), IsEmpty());
}

}  // namespace
}  // namespace polylume
