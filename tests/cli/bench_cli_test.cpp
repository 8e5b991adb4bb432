// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <nlohmann/json.hpp>

#include "command_fixture.hpp"

namespace polylume {
namespace {

using nlohmann::json;
using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class BenchTest : public test::CommandTest {
  protected:
    /// Small enough for a test, on a machine where others run: CPU time.
    static Outcome bench(std::vector<std::string> arguments) {
        const std::vector<std::string> all = {"bench", "--size",  "96x54", "--repeat",
                                              "2",     "--clock", "cpu"};
        arguments.insert(arguments.begin(), all.begin(), all.end());
        return runCommand(arguments);
    }
    /// Bad usage: exit code 2, nothing on standard output, nothing written.
    std::string reject(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "bench");
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        EXPECT_THAT(files(), IsEmpty());
        return outcome.error;
    }
};

TEST_F(BenchTest, helpShowsExamplesAndNames) {
    const Outcome outcome = runCommand({"bench", "--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("Examples:"), HasSubstr("polylume bench --quick"),
                      HasSubstr("textured-rectangle"), HasSubstr("two-lobes"), HasSubstr("--svg")));
    EXPECT_THAT(runCommand({"--help"}).output, HasSubstr("bench"));
}

TEST_F(BenchTest, tellsCostFloorAndRatios) {
    const Outcome outcome = bench({"--only", "rectangle,16-gon", "--models", "one-lobe,two-lobes",
                                   "--json", path("b.json"), "--svg", path("charts")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.output,
                AllOf(ContainsRegex("arithmetic +[0-9.]+ Gop/s"),
                      ContainsRegex("empty pass +[0-9.]+ +ns/pixel"),
                      ContainsRegex("\nrectangle, one-lobe +[0-9]+ +[0-9]+ +[0-9]+ +[0-9.]+"),
                      ContainsRegex("\n16-gon, two-lobes "),
                      ContainsRegex("textbook, unrolled +[0-9.]+ times as long"),
                      HasSubstr("CPU time over threads"), HasSubstr("96x54 pixels")));
    EXPECT_THAT(outcome.output, Not(HasSubstr("disk")));
    EXPECT_THAT(files(), ElementsAre("b.json", "charts"));

    const json report = json::parse(readText("b.json"));
    EXPECT_EQ(report["width"], 96);
    EXPECT_EQ(report["repeats"], 2);
    ASSERT_EQ(report["cases"].size(), 4u);
    const json& first = report["cases"][0];
    EXPECT_EQ(first["shape"], "rectangle");
    EXPECT_EQ(first["model"], "one-lobe");
    EXPECT_GT(first["operationsPerPixelAndLight"]["simple"], 100);
    const double nanoseconds = first["nanosecondsPerPixelAndLight"]["median"];
    const double floor = first["floor"]["nanoseconds"];
    EXPECT_GT(floor, 0.0);
    EXPECT_DOUBLE_EQ(first["ratioToFloor"], nanoseconds / floor);
    ASSERT_EQ(report["textbook"].size(), 3u);
    EXPECT_GT(report["machine"]["operationsPerSecond"]["median"], 1e8);
    for (const char* chart : {"shapes.svg", "models.svg", "floor.svg"}) {
        EXPECT_THAT(readText(std::string("charts/") + chart),
                    AllOf(HasSubstr("<svg"), HasSubstr("</svg>")));
    }
}

TEST_F(BenchTest, measuresScenesInPlaceOfShapes) {
    const Outcome outcome = bench({test::sourcePath("samples/scenes/cornell.glb"),
                                   test::sourcePath("samples/scenes/neon.glb"), "--json",
                                   path("b.json"), "--svg", path(".")});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("\ncornell.glb\n"), HasSubstr("\nneon.glb\n"),
                      ContainsRegex("area lights +1\n"), ContainsRegex("lighting +[0-9.]+ ms"),
                      ContainsRegex("peak memory +[0-9]+ MB"), Not(HasSubstr("textbook"))));
    const json report = json::parse(readText("b.json"));
    ASSERT_EQ(report["scenes"].size(), 2u);
    EXPECT_GT(report["scenes"][1]["areaLights"], 1);
    EXPECT_GT(report["scenes"][1]["lightingSeconds"]["median"], 0.0);
    EXPECT_GT(report["scenes"][0]["peakMemoryBytes"], 10'000'000);
    EXPECT_TRUE(report["scenes"][0]["lists"].is_null());
    EXPECT_THAT(readText("scenes.svg"), HasSubstr("area lights"));
}

TEST_F(BenchTest, rejectsBadUsage) {
    EXPECT_THAT(
        reject({"--only", "rectangle,hexagon"}),
        AllOf(HasSubstr("--only"), HasSubstr("textured-polygon"), HasSubstr("\"hexagon\"")));
    EXPECT_THAT(reject({"--models", "phong"}),
                AllOf(HasSubstr("one-lobe"), HasSubstr("\"phong\"")));
    EXPECT_THAT(reject({"--repeat", "0"}), HasSubstr("--repeat"));
    EXPECT_THAT(reject({"--size", "0x9"}), HasSubstr("--size"));
    EXPECT_THAT(reject({"--clock", "sundial"}), HasSubstr("auto|wall|cpu"));
    EXPECT_THAT(reject({"a.glb", "--only", "disk"}),
                AllOf(HasSubstr("--only"), HasSubstr("no scenes beside it")));
}

TEST_F(BenchTest, saysWhyItFailed) {
    const Outcome missing = bench({path("missing.glb")});
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_THAT(missing.error, HasSubstr("missing.glb"));
    EXPECT_THAT(missing.output, IsEmpty());
    writeText("taken", "");
    const Outcome taken = bench({"--svg", path("taken")});
    EXPECT_EQ(taken.exitCode, 1);
    EXPECT_THAT(taken.error, AllOf(HasSubstr("expected a folder"), HasSubstr("taken")));
    EXPECT_EQ(bench({"--json", path("no/such/folder.json")}).exitCode, 1);
}

}  // namespace
}  // namespace polylume
