// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>
#include <vector>

// Charts as SVG on a ground of their own, which is light or dark as the reader's screen is.
namespace polylume::bench {

/// What lies around a measured value: the length of the mark across it.
struct Spread {
    double low = 0.0;
    double high = 0.0;
};

struct Bar {
    std::string label;
    double value = 0.0;  ///< Above 0.
    Spread spread;
    std::string text;            ///< Beside the bar.
    std::optional<double> part;  ///< A share of the bar in a colour of its own, from the left.
    bool isOther = false;        ///< In the second colour: something to compare with.
};

/// Horizontal bars, one below the other, from 0; logarithmic where the longest is more than ten
/// times as long as the shortest.
struct BarChart {
    std::string title;
    std::string subtitle;
    std::string axis;  ///< What the values are, with the unit.
    std::vector<Bar> bars{};
    /// What the colours mean: of bars, of their parts, of other bars; empty: not said.
    std::string barMeaning{};
    std::string partMeaning{};
    std::string otherMeaning{};
};

struct ChartPoint {
    double x = 0.0;
    double y = 0.0;
    Spread spread;  ///< Of y.
};

struct ChartLine {
    std::string name;
    std::vector<ChartPoint> points;  ///< In the order of x.
};

/// Lines over two logarithmic axes; all values are above 0.
struct LineChart {
    std::string title;
    std::string subtitle;
    std::string xAxis;
    std::string yAxis;
    std::vector<ChartLine> lines;  ///< Four at most are told apart.
};

/// An SVG document.
std::string drawSvg(const BarChart& chart);
std::string drawSvg(const LineChart& chart);

/// About `count` round values from 0 to `most` or a little less, for an axis.
std::vector<double> linearTicks(double most, int count);
/// 1, 2 and 5 times powers of ten from `least` to `most`, powers of ten alone where that is many.
std::vector<double> logarithmicTicks(double least, double most);

}  // namespace polylume::bench
