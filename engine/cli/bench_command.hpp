// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "bench/lighting_bench.hpp"
#include "context/context.hpp"

namespace polylume::cli {

struct BenchCommand {
    std::vector<std::filesystem::path> scenes;  ///< Measured in place of the shapes, if any.
    Backend backend = Backend::automatic;
    bench::BenchOptions options;
    std::optional<float> lightThreshold;  ///< Of scenes.
    std::filesystem::path json;           ///< Empty: none.
    std::filesystem::path charts;         ///< Folder for SVG; empty: none.
};

/// Measures the lighting pass and prints what it found, and writes it as asked. Throws Error.
void run(const BenchCommand& command);

}  // namespace polylume::cli
