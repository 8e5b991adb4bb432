// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/bench_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/version.hpp"

namespace polylume::cli {
namespace {

using bench::Summary;
using nlohmann::ordered_json;

std::string quartilesText(const Summary& summary, int digits) {
    return fmt::format("{:.{}f} to {:.{}f}", summary.lowerQuartile, digits, summary.upperQuartile,
                       digits);
}

std::string headText(const bench::BenchResult& result) {
    return fmt::format("{}, {} ({})\n{}x{} pixels, median and quartiles of {} repeats\n",
                       result.context.renderer, result.context.version, result.context.backend,
                       result.size.x, result.size.y, result.repeatCount);
}

std::string rateText(const char* what, const bench::Rate& rate, const char* unit) {
    const Summary billions = {1e-9 * rate.perSecond.median, 1e-9 * rate.perSecond.lowerQuartile,
                              1e-9 * rate.perSecond.upperQuartile, 0.0, 0.0};
    return fmt::format("    {:<26}{:>8.1f} {:<8}({}; {})\n", what, billions.median, unit,
                       quartilesText(billions, 1), rate.way);
}

std::string machineText(const bench::BenchResult& result) {
    return fmt::format("\nthe machine, by this driver ({})\n", result.clock) +
           rateText("arithmetic", result.machine.operations, "Gop/s") +
           rateText("reads that pixels share", result.machine.sharedBytes, "GB/s") +
           rateText("pictures read and written", result.machine.streamBytes, "GB/s") +
           fmt::format("    {:<26}{:>8.2f} {:<8}({})\n", "empty pass", result.emptyPass.median,
                       "ns/pixel", quartilesText(result.emptyPass, 2));
}

/// A line of the table of costs.
std::string costRow(const std::string& name, const bench::Operations& operations,
                    const Summary& nanoseconds, const bench::Floor& floor,
                    const std::string& fixed) {
    return fmt::format("{:<32}{:>7}{:>8}{:>7}{:>8.2f}{}{:>10.2f}  {:<18}{:>7.2f}{:>10}\n", name,
                       operations.simple, operations.special, operations.bytes, floor.nanoseconds,
                       floor.isArithmetic ? " " : "*", nanoseconds.median,
                       quartilesText(nanoseconds, 2), nanoseconds.median / floor.nanoseconds,
                       fixed);
}

std::string caseName(const bench::BenchCase& which) {
    return fmt::format("{}, {}", bench::infoOf(which.shape).name, bench::infoOf(which.model).name);
}

std::string costText(const bench::BenchResult& result) {
    std::string text =
        "\n                                |        per pixel and light                        "
        "            | per pixel\n"
        "                                   ops special  bytes   floor    median  quartiles     "
        "       ratio     fixed\n"
        "                                                           ns        ns  ns              "
        "   to it        ns\n";
    for (const bench::CaseResult& one : result.cases) {
        text += costRow(caseName(one.which), one.operations, one.nanoseconds, one.floor,
                        fmt::format("{:.2f}", one.fixed.median));
    }
    for (const bench::TextbookResult& textbook : result.textbooks) {
        text += costRow(std::string(bench::infoOf(textbook.variant).name), textbook.operations,
                        textbook.nanoseconds, textbook.floor, "");
    }
    text +=
        "\nTo ours for the rectangle, in the same turns, the textbook formulation without a clip "
        "at the surface takes\n";
    for (const bench::TextbookResult& textbook : result.textbooks) {
        text += fmt::format("    {:<26}{:.2f} times as long ({})\n",
                            bench::infoOf(textbook.variant).name, textbook.ratio.median,
                            quartilesText(textbook.ratio, 2));
    }
    text += fmt::format(
        "\nops: additions, multiplications, comparisons, selections, per scalar; special: "
        "divisions, "
        "roots, logarithms, each\ncounted as {} ops. bytes: read of lights, without images. floor: "
        "what ops take at the rate of arithmetic, or where\nlonger (*) what the bytes take at that "
        "of "
        "shared reads. fixed: reading the G-buffer and the tables, less an empty pass.\n",
        bench::kSpecialWeight);
    return text;
}

std::string sweepText(const bench::BenchResult& result) {
    if (result.sweep.empty()) return "";
    std::string text = "\nrectangles    lighting, ms                    textbook, ms\n";
    for (const bench::SweepResult& step : result.sweep) {
        text += fmt::format("{:>10}{:>12.2f}  {:<20}{:>10.2f}  {}\n", step.lightCount,
                            step.milliseconds.median, quartilesText(step.milliseconds, 2),
                            step.textbookMilliseconds.median,
                            quartilesText(step.textbookMilliseconds, 2));
    }
    return text;
}

Summary inMilliseconds(const Summary& seconds) {
    return {1e3 * seconds.median, 1e3 * seconds.lowerQuartile, 1e3 * seconds.upperQuartile,
            1e3 * seconds.least, 1e3 * seconds.most};
}

std::string sceneText(const bench::SceneResult& scene) {
    const Summary lighting = inMilliseconds(scene.lightingSeconds);
    const Summary frame = inMilliseconds(scene.frameSeconds);
    std::string text =
        fmt::format("\n{}\n    {:<26}{}\n    {:<26}{:.2f} ms ({})\n    {:<26}{:.2f} ms ({})\n",
                    scene.name, "area lights", scene.lightCount, "lighting", lighting.median,
                    quartilesText(lighting, 2), "frame", frame.median, quartilesText(frame, 2));
    for (const bench::PassResult& pass : scene.passes) {
        text += fmt::format("      {:<24}{:.2f} ms\n", pass.name, pass.milliseconds.median);
    }
    if (scene.lists) {
        text += fmt::format("    {:<26}{:.3g} nits\n", "light threshold", scene.lists->threshold);
        if (const auto listed = scene.lists->lightsPerTile) {
            text +=
                fmt::format("    {:<26}{:.1f} and groups, mean\n", "listed for a tile", *listed);
        }
        text += fmt::format("    {:<26}{:.1f} a pixel, mean\n", "alone above the threshold",
                            scene.lists->lightsAboveThreshold);
    }
    return text + fmt::format("    {:<26}{:.0f} MB\n", "peak memory",
                              1e-6 * static_cast<double>(scene.peakMemoryBytes));
}

ordered_json jsonOf(const Summary& summary) {
    return {{"median", summary.median},
            {"lowerQuartile", summary.lowerQuartile},
            {"upperQuartile", summary.upperQuartile},
            {"least", summary.least},
            {"most", summary.most}};
}

ordered_json jsonOf(const bench::Operations& operations) {
    return {{"simple", operations.simple},
            {"special", operations.special},
            {"bytes", operations.bytes},
            {"samples", operations.samples}};
}

ordered_json jsonOf(const bench::Floor& floor) {
    return {{"nanoseconds", floor.nanoseconds},
            {"of", floor.isArithmetic ? "arithmetic" : "reads"}};
}

ordered_json jsonOf(const bench::Rate& rate) {
    ordered_json json = jsonOf(rate.perSecond);
    json["by"] = rate.way;
    return json;
}

ordered_json jsonOf(const bench::CaseResult& one) {
    return {{"shape", bench::infoOf(one.which.shape).name},
            {"model", bench::infoOf(one.which.model).name},
            {"lights", one.lightCount},
            {"nanosecondsPerPixelAndLight", jsonOf(one.nanoseconds)},
            {"operationsPerPixelAndLight", jsonOf(one.operations)},
            {"floor", jsonOf(one.floor)},
            {"ratioToFloor", one.ratio},
            {"nanosecondsPerPixel", jsonOf(one.fixed)},
            {"operationsPerPixel", jsonOf(one.pixelOperations)}};
}

ordered_json thresholdJson(const bench::SceneResult::Lists& lists) {
    return {{"thresholdNits", lists.threshold},
            {"lightsAboveThreshold", lists.lightsAboveThreshold}};
}

/// The same with what the lists hold; null where all lights are lit by.
ordered_json listsJson(const bench::SceneResult::Lists& lists) {
    if (!lists.lightsPerTile) return nullptr;
    ordered_json json = thresholdJson(lists);
    json["lightsPerTile"] = *lists.lightsPerTile;
    return json;
}

ordered_json jsonOf(const bench::SceneResult& scene) {
    ordered_json passes = ordered_json::object();
    for (const bench::PassResult& pass : scene.passes) {
        passes[pass.name] = jsonOf(pass.milliseconds);
    }
    return {{"name", scene.name},
            {"areaLights", scene.lightCount},
            {"lightingSeconds", jsonOf(scene.lightingSeconds)},
            {"frameSeconds", jsonOf(scene.frameSeconds)},
            {"passMilliseconds", passes},
            {"lists", scene.lists ? listsJson(*scene.lists) : ordered_json(nullptr)},
            {"threshold", scene.lists ? thresholdJson(*scene.lists) : ordered_json(nullptr)},
            {"peakMemoryBytes", scene.peakMemoryBytes}};
}

ordered_json shapesJson(const bench::BenchResult& result) {
    ordered_json json = {{"clock", result.clock},
                         {"specialWeight", bench::kSpecialWeight},
                         {"machine",
                          {{"operationsPerSecond", jsonOf(result.machine.operations)},
                           {"sharedBytesPerSecond", jsonOf(result.machine.sharedBytes)},
                           {"streamBytesPerSecond", jsonOf(result.machine.streamBytes)}}},
                         {"emptyPassNanosecondsPerPixel", jsonOf(result.emptyPass)},
                         {"cases", ordered_json::array()},
                         {"textbook", ordered_json::array()},
                         {"rectangles", ordered_json::array()}};
    for (const bench::CaseResult& one : result.cases) json["cases"].push_back(jsonOf(one));
    for (const bench::TextbookResult& textbook : result.textbooks) {
        json["textbook"].push_back({{"name", bench::infoOf(textbook.variant).name},
                                    {"nanosecondsPerPixelAndLight", jsonOf(textbook.nanoseconds)},
                                    {"ratioToOurs", jsonOf(textbook.ratio)},
                                    {"operationsPerPixelAndLight", jsonOf(textbook.operations)},
                                    {"floor", jsonOf(textbook.floor)}});
    }
    for (const bench::SweepResult& step : result.sweep) {
        json["rectangles"].push_back({{"lights", step.lightCount},
                                      {"lightingMilliseconds", jsonOf(step.milliseconds)},
                                      {"textbookMilliseconds", jsonOf(step.textbookMilliseconds)}});
    }
    return json;
}

}  // namespace

std::string benchText(const BenchReport& report) {
    const bench::BenchResult& result = report.result;
    std::string text = headText(result);
    if (report.scenes.empty()) {
        return text + machineText(result) + costText(result) + sweepText(result);
    }
    for (const bench::SceneResult& scene : report.scenes) text += sceneText(scene);
    return text;
}

std::string benchJson(const BenchReport& report) {
    const bench::BenchResult& result = report.result;
    ordered_json json = {{"polylume", kVersion},
                         {"backend", result.context.backend},
                         {"renderer", result.context.renderer},
                         {"glVersion", result.context.version},
                         {"software", result.context.software},
                         {"width", result.size.x},
                         {"height", result.size.y},
                         {"repeats", result.repeatCount}};
    if (report.scenes.empty()) {
        json.update(shapesJson(result));
    } else {
        json["scenes"] = ordered_json::array();
        for (const bench::SceneResult& scene : report.scenes) {
            json["scenes"].push_back(jsonOf(scene));
        }
    }
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace polylume::cli
