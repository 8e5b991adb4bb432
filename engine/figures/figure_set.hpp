// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "context/context.hpp"
#include "core/progress.hpp"

namespace polylume::figures {

/// The figures that makeFigures() knows, in the order of the page.
std::vector<std::string_view> figureNames();

struct FigureSetOptions {
    std::filesystem::path directory;  ///< Created where it is missing.
    std::string only;                 ///< One of figureNames(); empty: all.
    bool quick = false;               ///< Few cases, small pictures, few paths.
    Backend backend = Backend::automatic;
    int threadCount = 0;  ///< Most threads of the CPU's part; 0: one per processor.
    std::string version;  ///< Of the program, for the page.
};

/// Draws the figures to DIR/NAME/*.png and *.exr, and then the page DIR/index.html with those of
/// this run. Every file is written by way of a temporary file. A context is made where a figure
/// needs one. Throws Error.
void makeFigures(const FigureSetOptions& options, Progress& progress);

}  // namespace polylume::figures
