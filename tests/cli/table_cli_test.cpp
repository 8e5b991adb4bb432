// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command_fixture.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kGgx = test::sourcePath("tables/ggx.f32");
const std::string kTwoLobes = test::sourcePath("tables/ggx_two_lobes.f32");

class TableTest : public test::CommandTest {
  protected:
    /// Runs "polylume table ..." and expects it to fail with a message, leaving `output` alone.
    std::string failure(std::vector<std::string> arguments, int exitCode = 1) {
        arguments.insert(arguments.begin(), "table");
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, exitCode) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        return outcome.error;
    }
    Outcome run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "table");
        const Outcome outcome = runCommand(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
        return outcome;
    }
};

TEST_F(TableTest, infoTellsSizeAttributesAndRanges) {
    const Outcome outcome = run({"info", kTwoLobes});
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("64x64 nodes"), HasSubstr("brdf"), HasSubstr("ggx"),
                      HasSubstr("rootWidth2"), HasSubstr(" to "), HasSubstr("alphaFloor")));
}

TEST_F(TableTest, sampleGivesALineForEachPointAndLobe) {
    writeText("points", "# comment\n\n0.3 0.5\n1   0.25 # more\n\t0.05\t1\r\n");
    const Outcome outcome = run({"sample", kTwoLobes, "--at", path("points")});
    EXPECT_THAT(outcome.error, IsEmpty());
    std::istringstream lines(outcome.output);
    int lineCount = 0;
    double upper = 0.0;
    double r = 0, c = 0, weight = 0, m11 = 0, m31 = 0, m13 = 0, m33 = 0, albedo = 0, fresnel = 0;
    int lobe = 0;
    while (lines >> r >> c >> lobe >> weight >> m11 >> m31 >> m13 >> m33 >> albedo >> fresnel) {
        EXPECT_EQ(lobe, lineCount % 2 + 1);
        EXPECT_EQ(r, lineCount < 2 ? 0.3 : lineCount < 4 ? 1.0 : 0.05);
        EXPECT_EQ(c, lineCount < 2 ? 0.5 : lineCount < 4 ? 0.25 : 1.0);
        EXPECT_GT(m11 * m33 - m13 * m31, 0.0);
        EXPECT_TRUE(albedo > 0.0 && albedo <= 1.0 && fresnel >= 0.0 && fresnel <= albedo);
        // The weights make the lobes hold 1 above the surface.
        upper += weight * 0.5 * (1.0 + m11 / std::sqrt(m11 * m11 + m31 * m31));
        if (lobe == 2) {
            EXPECT_NEAR(upper, 1.0, 1e-12);
            upper = 0.0;
        }
        ++lineCount;
    }
    EXPECT_EQ(lineCount, 6);
}

TEST_F(TableTest, sampleRefusesBadLinesAndPrintsNothing) {
    const std::pair<const char*, const char*> cases[] = {
        {"0.3 0.5\n0.3\n", "line 2"},     {"0.3 0.5 1\n", "line 1"},   {"\n\n0.3 x\n", "line 3"},
        {"0.3 nan\n", "line 1"},          {"1.01 0.5\n", "roughness"}, {"0.5 -0.1\n", "cosine"},
        {"0.3 0.5\n0.3,0.5\n", "line 2"}, {"0x1 0.5\n", "\"0x1\""}};
    for (const auto& [text, expected] : cases) {
        writeText("points", text);
        EXPECT_THAT(failure({"sample", kGgx, "--at", path("points")}),
                    AllOf(HasSubstr(path("points")), HasSubstr(expected)));
    }
    EXPECT_THAT(failure({"sample", kGgx, "--at", path("none")}), HasSubstr(path("none")));
    EXPECT_THAT(failure({"sample", kGgx}, 2), HasSubstr("--at"));
}

TEST_F(TableTest, scoreIsTheSameAsTextAndJsonAndForAnyThreads) {
    const Outcome one = run({"score", kTwoLobes, "--json", "--threads", "1"});
    const Outcome two = run({"score", kTwoLobes, "--json", "--threads", "2"});
    EXPECT_EQ(one.output, two.output);
    const nlohmann::json json = nlohmann::json::parse(one.output);
    EXPECT_EQ(json.at("brdf"), "ggx");
    EXPECT_EQ(json.at("lobes"), 2);
    EXPECT_EQ(json.at("perRoughness").size(), 20u);
    const nlohmann::json& between = json.at("overall").at("betweenNodes");
    EXPECT_LT(between.at("l1").at("mean").get<double>(), 0.045);
    EXPECT_LT(between.at("polygon").at("mean").get<double>(), 0.025);
    EXPECT_LT(between.at("albedo").at("max").get<double>(), 0.002);
    const Outcome text = run({"score", kTwoLobes});
    EXPECT_THAT(text.output, AllOf(HasSubstr("roughness"), HasSubstr("0.05 |"), HasSubstr("all |"),
                                   HasSubstr("polygon")));
}

TEST_F(TableTest, scoreKnowsItsBrdfs) {
    EXPECT_THAT(failure({"score", kGgx, "--brdf", "nonsense"}),
                AllOf(HasSubstr("nonsense"), HasSubstr("ggx"), HasSubstr("merl:FILE")));
}

TEST_F(TableTest, exportsEveryFormat) {
    run({"export", kGgx, "-o", path("a.dds")});
    run({"export", kGgx, "-o", path("b.dds"), "--half"});
    run({"export", kTwoLobes, "-o", path("a.h")});
    run({"export", kTwoLobes, "-o", path("a.json")});
    run({"export", kGgx, "-o", path("a.f32")});
    run({"export", kTwoLobes, "-o", path("two.exr")});
    EXPECT_THAT(files(), ElementsAre("a.f32", "a.h", "a.json", "a_1.dds", "a_2.dds", "b_1.dds",
                                     "b_2.dds", "two.exr", "two.f32"));
    EXPECT_EQ(readText("a_1.dds").size(), 148u + 64 * 64 * 16);
    EXPECT_EQ(readText("b_1.dds").size(), 148u + 64 * 64 * 8);
    // The same table again, by way of the image.
    run({"export", path("two.exr"), "-o", path("again.f32")});
    EXPECT_EQ(readText("again.f32"), readText("two.f32"));
}

TEST_F(TableTest, exportRefusesWhatAFormatCannotHold) {
    writeText("a_1.dds", "old");
    EXPECT_THAT(failure({"export", kTwoLobes, "-o", path("a.dds")}), HasSubstr("one lobe"));
    EXPECT_EQ(readText("a_1.dds"), "old");
    EXPECT_THAT(failure({"export", kGgx, "-o", path("a.png")}, 2), HasSubstr(".json"));
    EXPECT_THAT(failure({"export", kGgx, "-o", path("a.h"), "--half"}, 2), HasSubstr("--half"));
    EXPECT_THAT(failure({"export", kGgx, "-o", path("none/a.h")}), HasSubstr("folder"));
    EXPECT_THAT(files(), ElementsAre("a_1.dds"));
}

TEST_F(TableTest, importReadsWhatExportWrites) {
    run({"export", kGgx, "-o", path("a.dds"), "--half"});
    run({"import", path("a_1.dds"), "-o", path("a.exr"), "--brdf", "ggx", "--alpha-floor", "1e-4"});
    const Outcome info = run({"info", path("a.exr")});
    EXPECT_THAT(info.output, AllOf(HasSubstr("classic"), HasSubstr("0.0001"), HasSubstr("m31")));
    const Outcome score = run({"score", path("a.exr"), "--json"});
    const nlohmann::json json = nlohmann::json::parse(score.output);
    EXPECT_LT(json.at("overall").at("betweenNodes").at("l1").at("mean").get<double>(), 0.075);
}

TEST_F(TableTest, importRefusesBadTexturesAndTheOldTableStays) {
    run({"export", kGgx, "-o", path("a.dds")});
    writeText("old.exr", "old");
    writeText("old.f32", "old");
    const auto fails = [&](const std::string& first, const std::string& second) {
        return failure(
            {"import", path(first), path(second), "-o", path("old.exr"), "--brdf", "ggx"});
    };
    writeText("short.dds", readText("a_1.dds").substr(0, 5000));
    EXPECT_THAT(fails("short.dds", "a_2.dds"),
                AllOf(HasSubstr(path("short.dds")), HasSubstr("cut short"), HasSubstr("5000")));
    std::string nan = readText("a_2.dds");
    nan.replace(148 + 16 * 70, 4, "\xff\xff\xff\x7f");
    writeText("nan.dds", nan);
    EXPECT_THAT(fails("a_1.dds", "nan.dds"),
                AllOf(HasSubstr("finite x in the second"), HasSubstr("(column 6, row 1)")));
    writeText("text.dds", std::string(200, 'x'));
    EXPECT_THAT(fails("text.dds", "a_2.dds"), HasSubstr("\"DDS \""));
    EXPECT_THAT(fails("none.dds", "a_2.dds"), HasSubstr("none.dds"));
    EXPECT_THAT(failure({"import", path("text.dds"), "-o", path("old.exr"), "--brdf", "ggx"}),
                HasSubstr("_1.dds"));
    EXPECT_THAT(failure({"import", path("a_1.dds"), "-o", path("old.exr")}, 2),
                HasSubstr("--brdf"));
    EXPECT_EQ(readText("old.exr"), "old");
    EXPECT_EQ(readText("old.f32"), "old");
}

TEST_F(TableTest, filesThatAreNoTablesAreRefused) {
    writeText("a.f32", "PLUMELTC");
    for (const char* command : {"info", "score"}) {
        EXPECT_THAT(failure({command, path("a.f32")}), HasSubstr(path("a.f32")));
        EXPECT_THAT(failure({command, path("none.exr")}), HasSubstr("none.exr"));
        EXPECT_THAT(failure({command, path("a.png")}), HasSubstr(".f32"));
    }
    std::string bytes;
    {
        run({"export", kGgx, "-o", path("b.f32")});
        bytes = readText("b.f32");
    }
    // The last value of the table is a NaN.
    bytes.replace(bytes.size() - 4, 4, "\xff\xff\xff\x7f");
    writeText("b.f32", bytes);
    EXPECT_THAT(failure({"info", path("b.f32")}),
                AllOf(HasSubstr("finite"), HasSubstr("(column 63, row 63)")));
}

TEST_F(TableTest, plotDrawsTwoPictures) {
    run({"plot", kTwoLobes, "-o", path("p.png"), "--cells", "0.3:40"});
    EXPECT_THAT(files(), ElementsAre("p_error.png", "p_lobes.png"));
    EXPECT_TRUE(readText("p_error.png").starts_with("\x89PNG"));
    for (const char* cells : {"0.3", "0.3:90", "2:10", "0.3:40;", "", "a:b"}) {
        EXPECT_THAT(failure({"plot", kGgx, "-o", path("q.png"), "--cells", cells}, 2),
                    HasSubstr("--cells"))
            << cells;
    }
    EXPECT_THAT(failure({"plot", kGgx, "-o", path("q.exr")}, 2), HasSubstr(".png"));
}

TEST_F(TableTest, aSubcommandIsRequiredAndHelpShowsExamples) {
    failure({}, 2);
    EXPECT_THAT(failure({"paint"}, 2), HasSubstr("paint"));
    for (const char* name : {"info", "score", "sample", "export", "import", "plot"}) {
        const Outcome help = run({name, "--help"});
        EXPECT_THAT(help.output,
                    AllOf(HasSubstr("Example"), HasSubstr(std::string("polylume table ") + name)));
    }
}

}  // namespace
}  // namespace polylume
