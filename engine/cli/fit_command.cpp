// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/fit_command.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "brdf/registry.hpp"
#include "cli/terminal.hpp"
#include "tables/table_file.hpp"

namespace polylume::cli {
namespace {

/// Of TableScore::betweenNodes: half of the light goes elsewhere.
constexpr double kPoorScore = 0.5;

}  // namespace

void run(const FitCommand& command) {
    const std::unique_ptr<brdf::Brdf> brdf = brdf::makeBrdf(command.brdf);
    tables::checkTablePath(command.output);
    ProgressBar progress("fitting");
    const ltc::Table table = fit::fitTable(*brdf, command.options, progress);
    tables::writeTable(command.output, table);
    const std::string& score = table.attributes().at("scoreBetweenNodes");
    if (std::stod(score) > kPoorScore) {
        log(LogLevel::warning,
            fmt::format("the lobes are far from the BRDF: a mean L1 error of {} between nodes; see "
                        "\"polylume table plot\"",
                        score));
    }
    log(LogLevel::info, fmt::format("wrote {} and {}", command.output.string(),
                                    tables::rawTablePath(command.output).string()));
}

}  // namespace polylume::cli
