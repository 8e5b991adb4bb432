// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/fit_command.hpp"

#include <fmt/format.h>

#include "brdf/ggx.hpp"
#include "cli/terminal.hpp"
#include "core/error.hpp"
#include "fit/fit_table.hpp"
#include "fit/table_file.hpp"

namespace polylume::cli {

void run(const FitCommand& command) {
    const brdf::Ggx ggx;
    if (command.brdf != ggx.name()) {
        throw Error(
            fmt::format("expected a BRDF out of {}; found \"{}\"", ggx.name(), command.brdf));
    }
    fit::checkTablePath(command.output);
    fit::FitOptions options;
    options.threadCount = command.threadCount;
    ProgressBar progress("fitting");
    const ltc::Table table = fit::fitTable(ggx, options, progress);
    fit::writeTable(command.output, table);
    log(LogLevel::info, fmt::format("wrote {} and {}", command.output.string(),
                                    fit::rawTablePath(command.output).string()));
}

}  // namespace polylume::cli
