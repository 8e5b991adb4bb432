// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/comparison.hpp"

namespace polylume::cli {

struct CompareCommand {
    std::filesystem::path test;
    std::filesystem::path reference;
    std::filesystem::path heatMap;      ///< .png; empty: none.
    std::vector<std::string> channels;  ///< Empty: all.
    double pixelsPerDegree = compare::kDefaultPixelsPerDegree;
    compare::Limits limits;
    bool json = false;
};

/// Prints how far two pictures are apart and writes the heat map; true where all limits pass.
/// Throws Error where the pictures can't be compared.
bool run(const CompareCommand& command);

}  // namespace polylume::cli
