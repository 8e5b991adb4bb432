// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/figures_command.hpp"

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "cli/version.hpp"

namespace polylume::cli {

void run(const FiguresCommand& command) {
    figures::FigureSetOptions options = command.options;
    options.version = kVersion;
    {
        ProgressBar progress("drawing figures");
        figures::makeFigures(options, progress);
    }
    log(LogLevel::info, fmt::format("wrote {}", (options.directory / "index.html").string()));
}

}  // namespace polylume::cli
