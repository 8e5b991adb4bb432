// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>

namespace polylume::cli {

struct FitCommand {
    std::string brdf = "ggx";
    std::filesystem::path output;  ///< .exr; the raw form goes beside it.
    int threadCount = 0;           ///< 0: one a core.
};

/// Fits a table and writes it. Throws Error.
void run(const FitCommand& command);

}  // namespace polylume::cli
