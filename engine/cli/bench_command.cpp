// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/bench_command.hpp"

#include <fmt/format.h>

#include "bench/bench_charts.hpp"
#include "cli/bench_report.hpp"
#include "cli/light_threshold.hpp"
#include "cli/picture.hpp"
#include "cli/terminal.hpp"
#include "core/file.hpp"
#include "figures/figure_folder.hpp"

namespace polylume::cli {
namespace {

namespace fs = std::filesystem;

void writeText(const fs::path& path, const std::string& text) {
    writeFile(path, std::as_bytes(std::span(text)));
    log(LogLevel::info, fmt::format("wrote {}", path.string()));
}

bench::SceneResult measureScene(const fs::path& path, const BenchCommand& command,
                                Context& context) {
    bench::beginPeakMemory();
    PictureRequest request;
    request.scene = path;
    RenderOptions options;
    options.size = command.options.size;
    options.lightThreshold = command.lightThreshold;
    setHalfStepThreshold(std::nullopt, request.toneMap, options);
    scene::Scene scene = readScene(request);
    completeScene(scene, request, options.size);
    ProgressBar progress(fmt::format("measuring {}", path.filename().string()));
    bench::SceneResult result =
        bench::runSceneBench(context, scene, chooseCamera(scene, request), options,
                             command.options.repeatCount, command.options.clock, progress);
    result.name = path.filename().string();
    return result;
}

BenchReport measureScenes(const BenchCommand& command, Context& context) {
    bench::BenchResult result;
    result.context = context.info();
    result.size = command.options.size;
    result.repeatCount = command.options.repeatCount;
    BenchReport report{result, {}};
    for (const fs::path& path : command.scenes) {
        report.scenes.push_back(measureScene(path, command, context));
    }
    return report;
}

BenchReport measureShapes(const BenchCommand& command, Context& context) {
    ProgressBar progress("measuring");
    return {runLightingBench(context, command.options, progress), {}};
}

}  // namespace

void run(const BenchCommand& command) {
    if (!command.json.empty()) checkWritable(command.json);
    if (!command.charts.empty()) figures::createFolder(command.charts);
    const std::unique_ptr<Context> context = Context::create(command.backend);
    const BenchReport report = command.scenes.empty() ? measureShapes(command, *context)
                                                      : measureScenes(command, *context);
    printReport(benchText(report));
    if (!command.json.empty()) writeText(command.json, benchJson(report));
    if (command.charts.empty()) return;
    const std::vector<bench::NamedChart> charts =
        command.scenes.empty()
            ? bench::drawCharts(report.result)
            : bench::drawCharts(report.scenes, report.result.size, report.result.context);
    for (const bench::NamedChart& chart : charts) {
        writeText(command.charts / chart.fileName, chart.svg);
    }
}

}  // namespace polylume::cli
