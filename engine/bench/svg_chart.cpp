// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/svg_chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"

namespace polylume::bench {
namespace {

constexpr double kWidth = 820.0;
constexpr double kTop = 74.0;
constexpr double kBottom = 52.0;

// Each colour is told from the ground by 3:1 and more (WCAG 2.1, 1.4.11), text by 4.5:1.
constexpr const char* kStyle = R"(<style>
  text { font-family: system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; font-size: 13px; fill: #1f2933; }
  .title { font-size: 17px; font-weight: 600; }
  .faint { fill: #55606e; }
  .end { text-anchor: end; }
  .middle { text-anchor: middle; }
  .ground { fill: #ffffff; stroke: #d9dee5; }
  .grid { stroke: #dfe4ea; }
  .spread { stroke: #1f2933; stroke-width: 1.4; fill: none; }
  .fill0 { fill: #2f6fd0; } .fill1 { fill: #c2661a; } .fill2 { fill: #14325f; } .fill3 { fill: #2e8540; }
  .line0 { stroke: #2f6fd0; } .line1 { stroke: #c2661a; } .line2 { stroke: #14325f; } .line3 { stroke: #2e8540; }
  .line { fill: none; stroke-width: 2.2; }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6ebf1; }
    .faint { fill: #a3afbd; }
    .ground { fill: #161b22; stroke: #303843; }
    .grid { stroke: #2c343f; }
    .spread { stroke: #e6ebf1; }
    .fill0 { fill: #5b9bf5; } .fill1 { fill: #e8924a; } .fill2 { fill: #bcd6ff; } .fill3 { fill: #63c174; }
    .line0 { stroke: #5b9bf5; } .line1 { stroke: #e8924a; } .line2 { stroke: #bcd6ff; } .line3 { stroke: #63c174; }
  }
</style>
)";

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string number(double value) {
    return formatNumber("%.1f", value);
}

std::string tickText(double value) {
    return formatNumber("%.6g", value);
}

std::string textAt(double x, double y, const std::string& style, const std::string& text) {
    return concat("<text x=\"", number(x), "\" y=\"", number(y), "\" class=\"", style, "\">",
                  escaped(text), "</text>\n");
}

std::string lineFrom(double x0, double y0, double x1, double y1, const char* style) {
    return concat("<path class=\"", style, "\" d=\"M", number(x0), ",", number(y0), "L", number(x1),
                  ",", number(y1), "\"/>\n");
}

std::string rectangle(double x, double y, double width, double height, const std::string& style) {
    return concat("<rect x=\"", number(x), "\" y=\"", number(y), "\" width=\"", number(width),
                  "\" height=\"", number(height), "\" class=\"", style, "\"/>\n");
}

std::string begin(double height, const std::string& title, const std::string& subtitle) {
    return concat("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", number(kWidth),
                  "\" height=\"", number(height), "\" viewBox=\"0 0 ", number(kWidth), " ",
                  number(height), "\" role=\"img\">\n<title>", escaped(title), "</title>\n", kStyle,
                  "<rect x=\"0.5\" y=\"0.5\" rx=\"8\" width=\"", number(kWidth - 1.0),
                  "\" height=\"", number(height - 1.0), "\" class=\"ground\"/>\n",
                  textAt(20.0, 30.0, "title", title), textAt(20.0, 51.0, "faint", subtitle));
}

/// An I across a value, along x or y.
std::string spreadMark(double low, double high, double at, bool alongX) {
    constexpr double kHalf = 4.0;
    const auto point = [&](double along, double across) {
        return alongX ? concat(number(along), ",", number(across))
                      : concat(number(across), ",", number(along));
    };
    return concat("<path class=\"spread\" d=\"M", point(low, at - kHalf), "L",
                  point(low, at + kHalf), "M", point(low, at), "L", point(high, at), "M",
                  point(high, at - kHalf), "L", point(high, at + kHalf), "\"/>\n");
}

/// Squares of colour with what they mean, from the right, above the plot.
std::string legend(const std::vector<std::pair<std::string, std::string>>& entries) {
    std::string out;
    double x = kWidth - 20.0;
    for (auto entry = entries.rbegin(); entry != entries.rend(); ++entry) {
        if (entry->second.empty()) continue;
        // About the width of the text.
        x -= 7.2 * static_cast<double>(entry->second.size());
        out += textAt(x, 30.0, "faint", entry->second);
        x -= 18.0;
        out += rectangle(x, 20.0, 12.0, 12.0, entry->first);
        x -= 16.0;
    }
    return out;
}

/// A logarithmic axis.
struct LogScale {
    double least;
    double most;
    double begin;
    double end;

    double operator()(double value) const {
        const double share = std::log(value / least) / std::log(most / least);
        return begin + share * (end - begin);
    }
};

/// The scale over all values and a little more on both sides.
LogScale makeScale(double least, double most, double begin, double end) {
    const double margin = std::max(1.3, std::pow(most / least, 0.04));
    return {least / margin, most * margin, begin, end};
}

struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;

    void include(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// The axis of bars: from 0, or logarithmic where bars at its short end could not be told apart.
struct BarScale {
    bool isLogarithmic = false;
    LogScale range;  ///< Its `least` counts for a logarithmic axis alone.

    double operator()(double value) const {
        if (isLogarithmic) return std::max(range(std::max(value, range.least)), range.begin);
        return range.begin + std::max(value, 0.0) / range.most * (range.end - range.begin);
    }
    std::vector<double> ticks() const {
        return isLogarithmic ? logarithmicTicks(range.least, range.most)
                             : linearTicks(range.most, 6);
    }
};

BarScale makeBarScale(const BarChart& chart, double begin, double end) {
    constexpr double kWide = 10.0;
    Extent extent;
    for (const Bar& bar : chart.bars) {
        extent.include(bar.value);
        extent.include(std::max(bar.value, bar.spread.high));
        if (bar.part) extent.include(*bar.part);
    }
    BarScale scale;
    // Half a decade before the shortest bar leaves it some length.
    const double least = extent.least / 3.0;
    scale.isLogarithmic = extent.least > 0.0 && extent.most > kWide * extent.least;
    scale.range = {least, extent.most > 0.0 ? extent.most : 1.0, begin, end};
    return scale;
}

std::string drawLine(const ChartLine& line, std::size_t index, bool isHighest, const LogScale& x,
                     const LogScale& y) {
    const std::string color = concat("line", index % 4);
    std::string path;
    std::string marks;
    for (const ChartPoint& point : line.points) {
        path += concat(path.empty() ? "M" : "L", number(x(point.x)), ",", number(y(point.y)));
        if (point.spread.low > 0.0 && point.spread.high > point.spread.low) {
            marks += spreadMark(y(point.spread.low), y(point.spread.high), x(point.x), false);
        }
        marks += concat("<circle cx=\"", number(x(point.x)), "\" cy=\"", number(y(point.y)),
                        "\" r=\"3.5\" class=\"fill", index % 4, "\"/>\n");
        marks += textAt(x(point.x), y(point.y) + (isHighest ? -10.0 : 19.0), "faint middle",
                        formatNumber("%.3g", point.y));
    }
    return concat("<path class=\"line ", color, "\" d=\"", path, "\"/>\n", marks);
}

/// Whether line `index` ends above all others, so that there is room above it.
bool isHighest(const LineChart& chart, std::size_t index) {
    const double end = chart.lines[index].points.back().y;
    return std::ranges::none_of(chart.lines, [&](const ChartLine& line) {
        return !line.points.empty() && line.points.back().y > end;
    });
}

}  // namespace

std::vector<double> linearTicks(double most, int count) {
    const double rough = most / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * power;
    for (const double factor : {5.0, 2.0, 1.0}) {
        if (factor * power >= rough * 0.999) step = factor * power;
    }
    std::vector<double> ticks;
    for (int i = 0; i * step <= most * 1.000001; ++i) ticks.push_back(i * step);
    return ticks;
}

std::vector<double> logarithmicTicks(double least, double most) {
    const bool isWide = most / least > 2000.0;
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(least))); power < 300; ++power) {
        const double decade = std::pow(10.0, power);
        if (decade > most) break;
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (isWide && factor > 1.0) continue;
            const double tick = factor * decade;
            if (tick >= least * 0.999999 && tick <= most * 1.000001) ticks.push_back(tick);
        }
    }
    return ticks;
}

std::string drawSvg(const BarChart& chart) {
    constexpr double kLeft = 184.0;
    constexpr double kRight = 150.0;
    constexpr double kBarHeight = 18.0;
    constexpr double kStep = 27.0;
    const double plotBottom = kTop + kStep * static_cast<double>(chart.bars.size());
    const BarScale x = makeBarScale(chart, kLeft, kWidth - kRight);

    std::string out = begin(plotBottom + kBottom, chart.title, chart.subtitle);
    out += legend(
        {{"fill2", chart.partMeaning}, {"fill0", chart.barMeaning}, {"fill1", chart.otherMeaning}});
    for (const double tick : x.ticks()) {
        out += lineFrom(x(tick), kTop - 6.0, x(tick), plotBottom, "grid");
        out += textAt(x(tick), plotBottom + 17.0, "faint middle", tickText(tick));
    }
    double y = kTop;
    for (const Bar& bar : chart.bars) {
        const double middle = y + 0.5 * kBarHeight;
        out += textAt(kLeft - 10.0, middle + 4.5, "end", bar.label);
        out +=
            rectangle(kLeft, y, x(bar.value) - kLeft, kBarHeight, bar.isOther ? "fill1" : "fill0");
        if (bar.part) out += rectangle(kLeft, y, x(*bar.part) - kLeft, kBarHeight, "fill2");
        double end = bar.value;
        if (bar.spread.high > bar.spread.low) {
            out += spreadMark(x(bar.spread.low), x(bar.spread.high), middle, true);
            end = std::max(end, bar.spread.high);
        }
        out += textAt(x(end) + 9.0, middle + 4.5, "value", bar.text);
        y += kStep;
    }
    out += textAt(kLeft, plotBottom + 39.0, "faint",
                  x.isLogarithmic ? chart.axis + "; logarithmic" : chart.axis);
    return out + "</svg>\n";
}

std::string drawSvg(const LineChart& chart) {
    constexpr double kHeight = 450.0;
    constexpr double kPlotTop = kTop + 22.0;
    constexpr double kLeft = 74.0;
    constexpr double kRight = 190.0;
    Extent xs;
    Extent ys;
    for (const ChartLine& line : chart.lines) {
        for (const ChartPoint& point : line.points) {
            xs.include(point.x);
            ys.include(point.y);
        }
    }
    std::string out = begin(kHeight, chart.title, chart.subtitle);
    if (xs.most <= 0.0) return out + "</svg>\n";
    const LogScale x = makeScale(xs.least, xs.most, kLeft, kWidth - kRight);
    const LogScale y = makeScale(ys.least, ys.most, kHeight - kBottom, kPlotTop);
    for (const double tick : logarithmicTicks(x.least, x.most)) {
        out += lineFrom(x(tick), kPlotTop, x(tick), kHeight - kBottom, "grid");
        out += textAt(x(tick), kHeight - kBottom + 17.0, "faint middle", tickText(tick));
    }
    for (const double tick : logarithmicTicks(y.least, y.most)) {
        out += lineFrom(kLeft, y(tick), kWidth - kRight, y(tick), "grid");
        out += textAt(kLeft - 8.0, y(tick) + 4.5, "faint end", tickText(tick));
    }
    double labelY = kHeight;
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        const ChartLine& line = chart.lines[i];
        if (line.points.empty()) continue;
        out += drawLine(line, i, isHighest(chart, i), x, y);
        // Names that would lie on each other move down.
        double at = y(line.points.back().y) + 4.5;
        if (std::abs(at - labelY) < 16.0) at = labelY + 16.0;
        labelY = at;
        out += rectangle(kWidth - kRight + 12.0, at - 10.0, 10.0, 10.0, concat("fill", i % 4));
        out += textAt(kWidth - kRight + 28.0, at, "value", line.name);
    }
    out += textAt(kLeft, kPlotTop - 9.0, "faint", chart.yAxis);
    out += textAt(kWidth - kRight, kHeight - 14.0, "faint end", chart.xAxis);
    return out + "</svg>\n";
}

}  // namespace polylume::bench
