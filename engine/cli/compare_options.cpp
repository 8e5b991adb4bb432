// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/compare_options.hpp"

#include <limits>
#include <set>

#include "cli/flags.hpp"

namespace polylume::cli {
namespace {

void addLimit(CLI::App& app, const std::string& flag, std::optional<double>& target,
              const std::string& description) {
    const auto parse = [flag](const std::string& text) -> std::optional<double> {
        const auto number = parseNumber<double>(text);
        if (!number || *number < 0.0) reject(flag, "a number from 0", text);
        return number;
    };
    addParsed(app, flag, target, parse, description)->option_text("X");
}

std::vector<std::string> parseChannels(const std::string& text) {
    std::vector<std::string> names = CLI::detail::split(text, ',');
    const std::set<std::string> distinct(names.begin(), names.end());
    if (distinct.count("") > 0 || distinct.size() != names.size()) {
        reject("--channels", "names apart by commas, each once, as R,G,B or normal.X", text);
    }
    return names;
}

void checkHeatMapName(const CompareCommand& command) {
    if (command.heatMap.empty() || command.heatMap.extension() == ".png") return;
    reject("--diff", "a file name that ends in .png", command.heatMap.string());
}

}  // namespace

CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command) {
    CLI::App* compare = app.add_subcommand("compare", "Say how far two pictures are apart");
    compare->footer(
        "Examples:\n"
        "  polylume compare found.png stored.png --flip-max 0.01 --diff difference.png\n"
        "  polylume compare ltc.exr truth.exr --max-rel-rmse 0.05 --json > report.json\n"
        "\n"
        "Files of integers hold sRGB-encoded display values, compared as 0 to 1 and by FLIP; "
        "files\n"
        "of floats hold linear radiance, compared as it is and by HDR-FLIP. Both must be of one\n"
        "kind, one size, and have the same channels, save a layer \"standardError\". Differences\n"
        "are A - B; relative ones are divided by the mean magnitude of B. --max-rel-rmse and\n"
        "--max-abs hold for the colours and for each other layer or channel.\n"
        "Exit codes: 0 within all limits (also with none), 1 not, or nothing to compare, 2 bad\n"
        "usage.");
    compare->add_option("a", command.test, "Picture under test, of any format of OpenImageIO")
        ->required()
        ->option_text("A");
    compare->add_option("b", command.reference, "Picture that it should be")
        ->required()
        ->option_text("B");
    compare
        ->add_option("--diff", command.heatMap,
                     "Write FLIP's heat map, dark where equal to pale yellow, whatever the limits")
        ->option_text("FILE.png");
    compare->add_flag("--json", command.json, "Print JSON in place of text");
    addLimit(*compare, "--max-rel-rmse", command.limits.relativeRmse,
             "Largest root mean square difference by the mean of B");
    addLimit(*compare, "--max-abs", command.limits.maximum,
             "Largest difference of any value, in the unit of the pictures");
    addLimit(*compare, "--flip-max", command.limits.meanFlip,
             "Largest mean of FLIP over the picture, 0 to 1");
    addParsed(*compare, "--channels", command.channels, parseChannels,
              "Compare these channels alone; default all")
        ->option_text("NAME,...");
    addNumber(*compare, "--pixels-per-degree", command.pixelsPerDegree, 1.0, 1000.0,
              "Pixels in a degree of the observer's view, for FLIP; default 67, a 4K screen of "
              "0.7 m from 0.7 m")
        ->option_text("N");
    compare->final_callback([&command] { checkHeatMapName(command); });
    return compare;
}

}  // namespace polylume::cli
