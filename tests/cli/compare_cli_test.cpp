// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "command_fixture.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"

namespace polylume {
namespace {

using test::Outcome;
using test::runCommand;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class CompareTest : public test::CommandTest {
  protected:
    /// A PNG of one colour but for the pixel (2, 1), whose green is `green`.
    std::string writePng(const std::string& name, std::uint8_t green, int width = 8) const {
        PixelImage image;
        image.width = width;
        image.height = 6;
        image.channelCount = 3;
        image.pixels.assign(static_cast<std::size_t>(width) * 6 * 3, 100);
        image.pixels[static_cast<std::size_t>(width + 2) * 3 + 1] = green;
        polylume::writePng(path(name), image, {});
        return path(name);
    }

    std::string writeExr(const std::string& name, const std::vector<std::string>& channels,
                         float value, int width = 8) const {
        FloatImage image;
        image.width = width;
        image.height = 6;
        image.channelNames = channels;
        image.pixels.assign(static_cast<std::size_t>(width) * 6 * channels.size(), 1.0f);
        image.pixel(2, 1)[0] = value;
        polylume::writeExr(path(name), image, ExrPrecision::single);
        return path(name);
    }

    static Outcome compare(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "compare");
        return runCommand(arguments);
    }

    /// Compares where that is impossible: nothing is reported or written.
    std::string failToCompare(const std::vector<std::string>& arguments) const {
        const std::vector<std::string> before = files();
        const Outcome outcome = compare(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        EXPECT_THAT(outcome.error, HasSubstr("error: "));
        EXPECT_EQ(files(), before);
        return outcome.error;
    }
};

TEST_F(CompareTest, equalPicturesPassEveryLimit) {
    const std::string a = writePng("a.png", 100);
    const Outcome outcome =
        compare({a, a, "--max-abs", "0", "--max-rel-rmse", "0", "--flip-max", "0"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.error, IsEmpty());
    EXPECT_THAT(outcome.output, AllOf(HasSubstr("8x6"), HasSubstr("equal everywhere"),
                                      HasSubstr("PASSED"), Not(HasSubstr("FAILED"))));
}

TEST_F(CompareTest, eachLimitDecidesTheExitCode) {
    const std::string a = writePng("a.png", 151);
    const std::string b = writePng("b.png", 100);
    EXPECT_EQ(compare({a, b}).exitCode, 0);
    const auto limits = {std::pair("--max-abs", 0.2), std::pair("--max-rel-rmse", 0.0425),
                         std::pair("--flip-max", 0.0)};
    // 51 of 255 steps at one value of 144: 0.2 and 0.2 / 12 / (100.354 / 255) = 0.04235. FLIP has
    // no such form, so what was found is taken for its limit below.
    for (const auto& [flag, limit] : limits) {
        const Outcome json = compare({a, b, "--json", "--flip-max", "1"});
        const double found = nlohmann::json::parse(json.output).at("flip").at("mean");
        const double pass = limit > 0.0 ? limit + 1e-6 : found * 1.001;
        const double fail = limit > 0.0 ? limit * 0.99 : found * 0.999;
        EXPECT_EQ(compare({a, b, flag, std::to_string(pass)}).exitCode, 0) << flag;
        const Outcome outcome = compare({a, b, flag, std::to_string(fail)});
        EXPECT_EQ(outcome.exitCode, 1) << flag;
        EXPECT_THAT(outcome.output, HasSubstr("FAILED"));
        EXPECT_THAT(outcome.error,
                    AllOf(HasSubstr(flag), HasSubstr("over the limit"), Not(HasSubstr("error:"))));
    }
}

TEST_F(CompareTest, jsonHoldsTheFigures) {
    const std::string a = writePng("a.png", 151);
    const std::string b = writePng("b.png", 100);
    const Outcome outcome = compare({a, b, "--json", "--max-abs", "0.1", "--flip-max", "0.9"});
    EXPECT_EQ(outcome.exitCode, 1);
    const nlohmann::json json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json.at("test"), a);
    EXPECT_EQ(json.at("reference"), b);
    EXPECT_EQ(json.at("width"), 8);
    EXPECT_EQ(json.at("height"), 6);
    EXPECT_EQ(json.at("values"), "display");
    EXPECT_EQ(json.at("passed"), false);
    const nlohmann::json& layer = json.at("layers").at(0);
    EXPECT_EQ(layer.at("name"), "color");
    EXPECT_NEAR(layer.at("maximum"), 0.2, 1e-6);
    EXPECT_EQ(layer.at("maximumAt").at("x"), 2);
    EXPECT_EQ(layer.at("maximumAt").at("y"), 1);
    EXPECT_EQ(layer.at("maximumAt").at("channel"), "G");
    EXPECT_NEAR(layer.at("rmse"), 0.2 / 12.0, 1e-6);
    EXPECT_NEAR(layer.at("bias"), 0.2 / 144.0, 1e-6);
    EXPECT_NEAR(layer.at("psnrDecibels"), 20.0 * std::log10(12.0 / 0.2), 1e-4);
    EXPECT_EQ(json.at("flip").at("maximumAt"), (nlohmann::json{{"x", 2}, {"y", 1}}));
    EXPECT_EQ(json.at("limits").at(0).at("flag"), "--max-abs");
    EXPECT_EQ(json.at("limits").at(0).at("passed"), false);
    EXPECT_EQ(json.at("limits").at(1).at("passed"), true);
}

TEST_F(CompareTest, jsonHasNullForTheInfinite) {
    const std::string a = writeExr("a.exr", {"R", "G", "B"}, 2.0f);
    const nlohmann::json equal = nlohmann::json::parse(compare({a, a, "--json"}).output);
    EXPECT_TRUE(equal.at("layers").at(0).at("psnrDecibels").is_null());
    EXPECT_EQ(equal.at("values"), "linear");
    EXPECT_EQ(equal.at("flip").at("exposures").at("count"), 2);
    EXPECT_EQ(equal.at("passed"), true);
}

TEST_F(CompareTest, jsonSaysWhyNothingWasCompared) {
    const Outcome outcome = compare({path("nowhere.png"), path("neither.png"), "--json"});
    EXPECT_EQ(outcome.exitCode, 1);
    const nlohmann::json json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json.at("passed"), false);
    EXPECT_THAT(json.at("error").get<std::string>(), HasSubstr("nowhere.png"));
    EXPECT_THAT(outcome.error, HasSubstr("nowhere.png"));
}

TEST_F(CompareTest, theHeatMapShowsWhereTheyDiffer) {
    const std::string a = writePng("a.png", 250);
    const std::string b = writePng("b.png", 100);
    const Outcome outcome = compare({a, b, "--diff", path("d.png"), "--max-abs", "0.01"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr("d.png"));
    EXPECT_THAT(files(), ElementsAre("a.png", "b.png", "d.png"));
    const FloatImage map = readImage(path("d.png"));
    ASSERT_EQ(map.width, 8);
    ASSERT_EQ(map.height, 6);
    const auto lightAt = [&](int x, int y) { return map.pixel(x, y)[0] + map.pixel(x, y)[1]; };
    EXPECT_THAT(lightAt(2, 1), Gt(lightAt(7, 5) + 0.1f));
}

TEST_F(CompareTest, theStandardErrorOfAReferenceIsNoDifference) {
    const std::string a = writeExr("a.exr", {"R", "G", "B", "A"}, 1.0f);
    const std::string b = writeExr(
        "b.exr", {"R", "G", "B", "A", "standardError.R", "standardError.G", "standardError.B"},
        1.0f);
    const Outcome outcome = compare({a, b, "--max-abs", "0"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    EXPECT_THAT(outcome.output, Not(HasSubstr("standardError")));
}

TEST_F(CompareTest, layersAreJudgedEach) {
    const std::string a = writeExr("a.exr", {"normal.X", "R", "G", "B"}, -1.0f);
    const std::string b = writeExr("b.exr", {"normal.X", "R", "G", "B"}, 1.0f);
    const Outcome outcome = compare({a, b, "--max-abs", "1.5", "--flip-max", "0"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_THAT(outcome.error, HasSubstr("normal largest difference 2, over"));
    EXPECT_EQ(compare({a, b, "--max-abs", "0", "--channels", "R,G,B"}).exitCode, 0);
}

TEST_F(CompareTest, whatCannotBeComparedIsNamed) {
    const std::string png = writePng("a.png", 100);
    const std::string wide = writePng("wide.png", 100, 9);
    const std::string exr = writeExr("a.exr", {"R", "G", "B"}, 1.0f);
    const std::string layered = writeExr("b.exr", {"R", "G", "B", "normal.X"}, 1.0f);
    const std::string broken =
        writeExr("nan.exr", {"R", "G", "B"}, std::numeric_limits<float>::quiet_NaN());
    writeText("text.png", "no picture");
    const std::string map = path("d.png");
    EXPECT_THAT(failToCompare({png, wide, "--diff", map}),
                AllOf(HasSubstr("8x6"), HasSubstr("9x6"), HasSubstr("wide.png")));
    EXPECT_THAT(failToCompare({png, exr, "--diff", map}),
                AllOf(HasSubstr("display"), HasSubstr("linear")));
    EXPECT_THAT(failToCompare({exr, layered, "--diff", map}),
                AllOf(HasSubstr("normal.X"), HasSubstr("--channels R,G,B")));
    EXPECT_THAT(failToCompare({exr, broken, "--diff", map}),
                AllOf(HasSubstr("nan.exr"), HasSubstr("channel R of pixel (2, 1)")));
    EXPECT_THAT(failToCompare({broken, broken}), HasSubstr("finite"));
    EXPECT_THAT(failToCompare({path("none.png"), png}), HasSubstr("none.png"));
    EXPECT_THAT(failToCompare({path(""), png}), HasSubstr("folder"));
    EXPECT_THAT(failToCompare({png, path("text.png")}), HasSubstr("text.png"));
    EXPECT_THAT(failToCompare({png, png, "--channels", "R,Q"}), HasSubstr("found no Q"));
    EXPECT_THAT(failToCompare({layered, layered, "--channels", "normal.X,R", "--flip-max", "1"}),
                HasSubstr("FLIP"));
    EXPECT_THAT(failToCompare({layered, layered, "--channels", "normal.X,R", "--diff", map}),
                HasSubstr("--diff"));
    // A picture is never overwritten by its own difference.
    EXPECT_THAT(failToCompare({png, wide, "--diff", png}), HasSubstr("--diff"));
    EXPECT_THAT(failToCompare({png, png, "--diff", path("none/d.png")}), HasSubstr("none"));
}

TEST_F(CompareTest, badUsageIsToldApart) {
    const auto reject = [](std::vector<std::string> arguments) {
        const Outcome outcome = compare(std::move(arguments));
        EXPECT_EQ(outcome.exitCode, 2) << outcome.error;
        EXPECT_THAT(outcome.output, IsEmpty());
        return outcome.error;
    };
    EXPECT_THAT(reject({"a.png"}), HasSubstr("required"));
    for (const char* flag : {"--max-abs", "--max-rel-rmse", "--flip-max"}) {
        for (const char* value : {"-1", "nan", "inf", "much", ""}) {
            EXPECT_THAT(reject({"a.png", "b.png", std::string(flag) + "=" + value}),
                        HasSubstr(flag));
        }
    }
    EXPECT_THAT(reject({"a.png", "b.png", "--diff", "d.jpg"}), HasSubstr(".png"));
    EXPECT_THAT(reject({"a.png", "b.png", "--channels", "R,,B"}), HasSubstr("--channels"));
    EXPECT_THAT(reject({"a.png", "b.png", "--channels", "R,R"}), HasSubstr("--channels"));
    EXPECT_THAT(reject({"a.png", "b.png", "--pixels-per-degree", "0"}), HasSubstr("1000"));
}

TEST_F(CompareTest, helpSaysWhatIsMeasured) {
    const Outcome outcome = compare({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("Examples:"), HasSubstr("--diff"), HasSubstr("--json"),
                      HasSubstr("--max-rel-rmse"), HasSubstr("--max-abs"), HasSubstr("--flip-max"),
                      HasSubstr("--channels"), HasSubstr("--pixels-per-degree"),
                      HasSubstr("mean of FLIP"), HasSubstr("Exit codes")));
}

}  // namespace
}  // namespace polylume
