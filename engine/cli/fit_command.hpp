// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>

#include "fit/fit_table.hpp"

namespace polylume::cli {

struct FitCommand {
    std::string brdf = "ggx";      ///< As brdf::makeBrdf() takes it.
    std::filesystem::path output;  ///< .exr; the raw form goes beside it.
    fit::FitOptions options;
};

/// Fits a table and writes it. Throws Error.
void run(const FitCommand& command);

}  // namespace polylume::cli
