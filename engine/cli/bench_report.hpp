// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "bench/lighting_bench.hpp"
#include "bench/scene_bench.hpp"

namespace polylume::cli {

struct BenchReport {
    bench::BenchResult result;  ///< Context, size and repeats alone where there are scenes.
    std::vector<bench::SceneResult> scenes;
};

/// A report as tables of text, or as a JSON object.
std::string benchText(const BenchReport& report);
std::string benchJson(const BenchReport& report);

}  // namespace polylume::cli
