// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/bench_charts.hpp"

#include <algorithm>

#include "bench/svg_chart.hpp"
#include "core/text.hpp"

namespace polylume::bench {
namespace {

constexpr const char* kPerLight = "nanoseconds per pixel and light; marks: quartiles";

Spread quartilesOf(const Summary& summary, double scale = 1.0) {
    return {scale * summary.lowerQuartile, scale * summary.upperQuartile};
}

std::string placeOf(glm::ivec2 size, const ContextInfo& context) {
    return concat(size.x, "x", size.y, ", ", context.renderer);
}

std::string nanosecondText(double nanoseconds) {
    return formatNumber("%.3g", nanoseconds) + " ns";
}

Bar makeBar(std::string label, const Summary& nanoseconds) {
    return {std::move(label),
            nanoseconds.median,
            quartilesOf(nanoseconds),
            nanosecondText(nanoseconds.median),
            std::nullopt,
            false};
}

Bar textbookBar(const TextbookResult& textbook) {
    Bar bar = makeBar(std::string(infoOf(textbook.variant).name), textbook.nanoseconds);
    bar.text += concat(", ", formatNumber("%.2f", textbook.ratio.median), " times ours");
    bar.isOther = true;
    return bar;
}

std::string nameOf(const BenchCase& which) {
    return which.model == Model::oneLobe
               ? std::string(infoOf(which.shape).name)
               : concat(infoOf(which.shape).name, ", ", infoOf(which.model).name);
}

BarChart shapesChart(const BenchResult& result) {
    BarChart chart{
        "Lighting cost by shape",
        "diffuse and GGX, one lobe, exact clips; " + placeOf(result.size, result.context),
        kPerLight};
    for (const CaseResult& one : result.cases) {
        if (one.which.model != Model::oneLobe) continue;
        chart.bars.push_back(makeBar(nameOf(one.which), one.nanoseconds));
    }
    if (chart.bars.empty()) return chart;
    for (const TextbookResult& textbook : result.textbooks) {
        chart.bars.push_back(textbookBar(textbook));
    }
    chart.barMeaning = "Polylume";
    chart.otherMeaning = "textbook formulation";
    return chart;
}

BarChart modelsChart(const BenchResult& result) {
    BarChart chart{"Lighting cost by reflection model",
                   "rectangle; " + placeOf(result.size, result.context), kPerLight};
    for (const CaseResult& one : result.cases) {
        if (one.which.shape != Shape::rectangle) continue;
        chart.bars.push_back(makeBar(std::string(infoOf(one.which.model).name), one.nanoseconds));
    }
    if (chart.bars.size() < 2) chart.bars.clear();
    return chart;
}

BarChart floorChart(const BenchResult& result) {
    BarChart chart{"Lighting cost against the floor",
                   concat("floor: all operations at ",
                          formatNumber("%.0f", 1e-9 * result.machine.operations.perSecond.median),
                          " Gop/s, what a shader of nothing else reaches; ",
                          placeOf(result.size, result.context)),
                   "nanoseconds per pixel and light; beside each bar its ratio to the floor"};
    const auto bar = [](std::string label, const Summary& nanoseconds, const Floor& floor) {
        Bar made = makeBar(std::move(label), nanoseconds);
        made.part = floor.nanoseconds;
        made.text +=
            concat(", ", formatNumber("%.2f", nanoseconds.median / floor.nanoseconds), " x");
        return made;
    };
    for (const CaseResult& one : result.cases) {
        chart.bars.push_back(bar(nameOf(one.which), one.nanoseconds, one.floor));
    }
    if (chart.bars.empty()) return chart;
    for (const TextbookResult& textbook : result.textbooks) {
        const std::string name(infoOf(textbook.variant).name);
        chart.bars.push_back(bar(name, textbook.nanoseconds, textbook.floor));
        chart.bars.back().isOther = true;
    }
    chart.partMeaning = "floor";
    chart.barMeaning = "measured";
    chart.otherMeaning = "textbook formulation";
    return chart;
}

LineChart lightsChart(const BenchResult& result) {
    LineChart chart{"Lighting time by number of lights",
                    "rectangles over a floor that fills the picture, none left out; " +
                        placeOf(result.size, result.context),
                    "lights",
                    "milliseconds a picture; marks: quartiles",
                    {{"rectangles", {}}, {"textbook, unrolled", {}}}};
    for (const SweepResult& step : result.sweep) {
        const double lights = step.lightCount;
        chart.lines[0].points.push_back(
            {lights, step.milliseconds.median, quartilesOf(step.milliseconds)});
        chart.lines[1].points.push_back(
            {lights, step.textbookMilliseconds.median, quartilesOf(step.textbookMilliseconds)});
    }
    return chart;
}

}  // namespace

std::vector<NamedChart> drawCharts(const BenchResult& result) {
    std::vector<NamedChart> charts;
    const auto add = [&](const char* fileName, const BarChart& chart) {
        if (!chart.bars.empty()) charts.push_back({fileName, drawSvg(chart)});
    };
    add("shapes.svg", shapesChart(result));
    add("models.svg", modelsChart(result));
    add("floor.svg", floorChart(result));
    if (!result.sweep.empty()) charts.push_back({"lights.svg", drawSvg(lightsChart(result))});
    return charts;
}

std::vector<NamedChart> drawCharts(std::span<const SceneResult> scenes, glm::ivec2 size,
                                   const ContextInfo& context) {
    LineChart chart{"Lighting time of scenes by number of lights",
                    placeOf(size, context),
                    "area lights",
                    "milliseconds a picture; marks: quartiles",
                    {{"scenes", {}}}};
    std::vector<ChartPoint>& points = chart.lines[0].points;
    for (const SceneResult& scene : scenes) {
        if (scene.lightCount == 0 || scene.lightingSeconds.median <= 0.0) continue;
        points.push_back({static_cast<double>(scene.lightCount), 1e3 * scene.lightingSeconds.median,
                          quartilesOf(scene.lightingSeconds, 1e3)});
    }
    std::ranges::sort(points, {}, &ChartPoint::x);
    if (points.empty()) return {};
    return {{"scenes.svg", drawSvg(chart)}};
}

}  // namespace polylume::bench
