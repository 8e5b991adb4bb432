// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/figures_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/flags.hpp"

namespace polylume::cli {
namespace {

std::string parseFigure(const std::string& text) {
    const std::vector<std::string_view> names = figures::figureNames();
    if (std::ranges::find(names, text) == names.end()) {
        reject("--only", fmt::format("one of {}", fmt::join(names, ", ")), text);
    }
    return text;
}

}  // namespace

CLI::App* addFiguresCommand(CLI::App& app, FiguresCommand& command) {
    CLI::App* figures =
        app.add_subcommand("figures", "Draw how LTC compare with the ray-traced truth");
    figures->footer(
        "Examples:\n"
        "  polylume figures -o figures\n"
        "  polylume figures -o figures --quick\n"
        "  polylume figures -o figures --only floor\n"
        "\n"
        "Writes DIR/NAME/*.png and *.exr (linear, nits) and one page, DIR/index.html, that shows\n"
        "this run's figures with sliders, errors and times. The page is whole in itself. The\n"
        "whole set takes minutes, --quick seconds.");
    figures->add_option("-o,--output", command.options.directory, "Folder; made where missing")
        ->required()
        ->option_text("DIR");
    addParsed(*figures, "--only", command.options.only, parseFigure,
              fmt::format("One figure alone: {}", fmt::join(figures::figureNames(), ", ")))
        ->option_text("NAME");
    figures->add_flag("--quick", command.options.quick,
                      "Few cases, small pictures, few light paths");
    addChoice<Backend>(
        *figures, "--backend", command.options.backend,
        {{"auto", Backend::automatic}, {"egl", Backend::egl}, {"osmesa", Backend::osmesa}},
        "Where the OpenGL context comes from; default auto");
    addThreads(*figures, command.options.threadCount);
    return figures;
}

}  // namespace polylume::cli
