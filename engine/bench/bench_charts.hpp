// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <string>
#include <vector>

#include "bench/lighting_bench.hpp"
#include "bench/scene_bench.hpp"

namespace polylume::bench {

/// A chart with its file's name, without a folder.
struct NamedChart {
    std::string fileName;
    std::string svg;
};

/// Cost against shapes, models, the floor and the number of lights; a chart with nothing to show is
/// left out.
std::vector<NamedChart> drawCharts(const BenchResult& result);

/// Lighting time of scenes against their number of lights.
std::vector<NamedChart> drawCharts(std::span<const SceneResult> scenes, glm::ivec2 size,
                                   const ContextInfo& context);

}  // namespace polylume::bench
