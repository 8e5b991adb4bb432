// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "figures/lobe_figure.hpp"
#include "tables/dds_format.hpp"

namespace polylume::cli {

struct TableInfoCommand {
    std::filesystem::path table;
};

struct TableScoreCommand {
    std::filesystem::path table;
    std::string brdf;  ///< Empty: what the table says.
    bool json = false;
    int threadCount = 0;  ///< 0: one a core.
};

struct TableSampleCommand {
    std::filesystem::path table;
    std::filesystem::path points;  ///< "-": standard input.
};

struct TableExportCommand {
    std::filesystem::path table;
    std::filesystem::path output;
    tables::DdsPrecision precision = tables::DdsPrecision::single;
};

struct TableImportCommand {
    std::filesystem::path first;
    std::filesystem::path second;  ///< Empty: by the name of the first.
    std::filesystem::path output;  ///< .exr; the raw form goes beside it.
    std::string brdf;
    double alphaFloor = 0.0;
};

struct TablePlotCommand {
    std::filesystem::path table;
    std::filesystem::path output;  ///< .png; "_error" and "_lobes" go before that.
    std::string brdf;              ///< Empty: what the table says.
    std::vector<figures::LobeCell> cells = figures::defaultLobeCells();
};

// Each does its work and throws Error.
void run(const TableInfoCommand& command);
void run(const TableScoreCommand& command);
void run(const TableSampleCommand& command);
void run(const TableExportCommand& command);
void run(const TableImportCommand& command);
void run(const TablePlotCommand& command);

}  // namespace polylume::cli
