// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/compare_command.hpp"

#include <fmt/format.h>

#include "cli/compare_report.hpp"
#include "cli/terminal.hpp"
#include "core/file.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume::cli {
namespace {

namespace fs = std::filesystem;

/// The picture's file must not be taken for the one to write.
void checkHeatMap(const CompareCommand& command) {
    if (command.heatMap.empty()) return;
    checkWritable(command.heatMap);
    for (const fs::path& picture : {command.test, command.reference}) {
        std::error_code ignored;
        if (fs::equivalent(command.heatMap, picture, ignored)) {
            throw Error(
                fmt::format("expected a file of its own for --diff, found {}, which is "
                            "compared",
                            command.heatMap.string()));
        }
    }
}

compare::NamedPicture readPicture(const fs::path& path) {
    compare::NamedPicture picture{path.string(), readImage(path)};
    if (picture.image.hasMoreParts) {
        log(LogLevel::warning,
            fmt::format("{} holds more than one picture; only the first is compared",
                        picture.name));
    }
    return picture;
}

bool compareAndReport(const CompareCommand& command) {
    checkHeatMap(command);
    const compare::NamedPicture test = readPicture(command.test);
    const compare::NamedPicture reference = readPicture(command.reference);
    const compare::PicturePair pair(test, reference, command.channels);
    if (!command.heatMap.empty() && !pair.hasColor()) {
        throw Error(
            "expected colours for the heat map of --diff, R, G and B or a grey Y; found "
            "none in what is compared");
    }
    compare::Comparison comparison;
    {
        ProgressBar progress("comparing");
        comparison = comparePictures(pair, command.pixelsPerDegree, progress);
    }
    const std::vector<compare::Verdict> verdicts = checkLimits(comparison, command.limits);
    if (!command.heatMap.empty()) {
        writePng(command.heatMap, compare::heatMap(comparison.flipMap), {});
        log(LogLevel::info, fmt::format("wrote {}", command.heatMap.string()));
    }
    const CompareReport report{test.name, reference.name, comparison, verdicts};
    printReport(command.json ? compareJson(report) : compareText(report));
    for (const compare::Verdict& verdict : verdicts) {
        if (!verdict.passed) log(LogLevel::warning, describe(verdict));
    }
    return allPassed(verdicts);
}

}  // namespace

bool run(const CompareCommand& command) {
    try {
        return compareAndReport(command);
    } catch (const Error& error) {
        // Who reads the report finds the reason there, too.
        if (command.json) printReport(failureJson(command, error.what()));
        throw;
    }
}

}  // namespace polylume::cli
