// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/svg_chart.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <regex>

namespace polylume::bench {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The numbers of attribute `name` of all elements of class `style`.
std::vector<double> attributes(const std::string& svg, const std::string& name,
                               const std::string& style) {
    std::vector<double> found;
    const std::regex pattern(name + "=\"([-0-9.]+)\"[^>]*class=\"" + style + "\"");
    for (std::sregex_iterator i(svg.begin(), svg.end(), pattern), end; i != end; ++i) {
        found.push_back(std::stod((*i)[1]));
    }
    return found;
}

TEST(SvgChartTest, ticksAreRound) {
    EXPECT_THAT(linearTicks(34.6, 6), ElementsAre(0.0, 10.0, 20.0, 30.0));
    EXPECT_THAT(linearTicks(6.0, 6), ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
    EXPECT_THAT(logarithmicTicks(0.9, 21.0), ElementsAre(1.0, 2.0, 5.0, 10.0, 20.0));
    EXPECT_THAT(logarithmicTicks(1.0, 10000.0), ElementsAre(1.0, 10.0, 100.0, 1000.0, 10000.0));
}

TEST(SvgChartTest, barsAreAsLongAsTheirValues) {
    BarChart chart;
    chart.bars = {{"a", 2.0, {}, "two", 1.0, false}, {"b", 8.0, {}, "eight", std::nullopt, false}};
    const std::string svg = drawSvg(chart);
    const std::vector<double> bars = attributes(svg, "width", "fill0");
    ASSERT_EQ(bars.size(), 2u);
    // A tenth of a unit is kept of 486.
    EXPECT_THAT(bars[1], DoubleNear(4.0 * bars[0], 0.3));
    EXPECT_THAT(attributes(svg, "width", "fill2"), ElementsAre(DoubleNear(0.5 * bars[0], 0.1)));
    EXPECT_THAT(svg, Not(HasSubstr("logarithmic")));
}

TEST(SvgChartTest, barsOfAWideRangeAreLogarithmic) {
    BarChart chart;
    chart.bars = {{"a", 2.0, {}, "", std::nullopt, false},
                  {"b", 20.0, {}, "", std::nullopt, false},
                  {"c", 200.0, {}, "", std::nullopt, true}};
    const std::string svg = drawSvg(chart);
    const std::vector<double> bars = attributes(svg, "width", "fill0");
    const std::vector<double> other = attributes(svg, "width", "fill1");
    ASSERT_EQ(bars.size(), 2u);
    ASSERT_EQ(other.size(), 1u);
    EXPECT_GT(bars[0], 0.0);
    EXPECT_THAT(other[0] - bars[1], DoubleNear(bars[1] - bars[0], 0.3));
    EXPECT_THAT(svg, HasSubstr("logarithmic"));
}

TEST(SvgChartTest, powersLieOnAStraightLine) {
    LineChart chart;
    chart.lines = {{"square", {{1, 1, {}}, {10, 100, {}}, {100, 10000, {}}}}};
    const std::string svg = drawSvg(chart);
    const std::vector<double> x = attributes(svg, "cx", "fill0");
    const std::vector<double> y = attributes(svg, "cy", "fill0");
    ASSERT_EQ(x.size(), 3u);
    EXPECT_THAT(x[2] - x[1], DoubleNear(x[1] - x[0], 0.2));
    EXPECT_THAT(y[2] - y[1], DoubleNear(y[1] - y[0], 0.2));
    EXPECT_LT(y[2], y[0]);
}

TEST(SvgChartTest, textIsEscapedAndBothGroundsAreThere) {
    BarChart chart;
    chart.title = "a < b & c";
    const std::string svg = drawSvg(chart);
    EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
    EXPECT_THAT(svg, HasSubstr("prefers-color-scheme: dark"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(drawSvg(LineChart{}), HasSubstr("</svg>"));
}

}  // namespace
}  // namespace polylume::bench
