// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/bench_charts.hpp"

#include <gmock/gmock.h>

namespace polylume::bench {
namespace {

using ::testing::HasSubstr;

Summary exactly(double value) {
    return {value, value, value, value, value};
}

BenchResult makeResult() {
    BenchResult result;
    result.context.renderer = "some renderer";
    result.size = {64, 32};
    for (const Model model : {Model::oneLobe, Model::twoLobes}) {
        CaseResult one;
        one.which = {Shape::rectangle, model};
        one.nanoseconds = exactly(12.0);
        one.floor = {4.0, true};
        result.cases.push_back(one);
    }
    result.textbooks.push_back({Textbook::unrolled, exactly(36.0), exactly(3.0), {}, {6.0, true}});
    result.sweep = {{1, exactly(2.0), exactly(3.0)}, {4, exactly(4.0), exactly(7.0)}};
    return result;
}

TEST(BenchChartsTest, saysValuesAndRatios) {
    const std::vector<NamedChart> charts = drawCharts(makeResult());
    ASSERT_EQ(charts.size(), 4u);
    EXPECT_EQ(charts[0].fileName, "shapes.svg");
    EXPECT_THAT(charts[0].svg, HasSubstr("36 ns, 3.00 times ours"));
    EXPECT_EQ(charts[1].fileName, "models.svg");
    EXPECT_EQ(charts[2].fileName, "floor.svg");
    EXPECT_THAT(charts[2].svg, HasSubstr("12 ns, 3.00 x"));
    EXPECT_THAT(charts[2].svg, HasSubstr("36 ns, 6.00 x"));
    EXPECT_EQ(charts[3].fileName, "lights.svg");
    for (const NamedChart& chart : charts) {
        EXPECT_THAT(chart.svg, HasSubstr("64x32, some renderer"));
    }
}

TEST(BenchChartsTest, leavesOutWhatWasNotMeasured) {
    BenchResult result = makeResult();
    result.cases.pop_back();
    result.sweep.clear();
    const std::vector<NamedChart> charts = drawCharts(result);
    ASSERT_EQ(charts.size(), 2u);
    EXPECT_EQ(charts[0].fileName, "shapes.svg");
    EXPECT_EQ(charts[1].fileName, "floor.svg");
}

TEST(BenchChartsTest, scenesWithLightsAreDrawn) {
    std::vector<SceneResult> scenes(3);
    scenes[0].lightCount = 16;
    scenes[0].lightingSeconds = exactly(0.25);
    scenes[1].lightCount = 1000;
    scenes[1].lightingSeconds = exactly(1.5);
    const std::vector<NamedChart> charts = drawCharts(scenes, {64, 32}, {});
    ASSERT_EQ(charts.size(), 1u);
    EXPECT_EQ(charts[0].fileName, "scenes.svg");
    EXPECT_THAT(charts[0].svg, HasSubstr(">1.5e+03<"));
    EXPECT_THAT(charts[0].svg, HasSubstr(">250<"));
    EXPECT_TRUE(drawCharts(std::span(scenes).last(1), {64, 32}, {}).empty());
}

}  // namespace
}  // namespace polylume::bench
