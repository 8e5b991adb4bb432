// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/stopwatch.hpp"
#include "bench/summary.hpp"
#include "context/context.hpp"
#include "core/progress.hpp"
#include "render/renderer.hpp"

namespace polylume::bench {

/// A pass of a frame, in the order in which they run.
struct PassResult {
    std::string name;
    Summary milliseconds;
};

/// Frames of one scene.
struct SceneResult {
    std::string name;
    int lightCount = 0;  ///< Area lights.
    Summary lightingSeconds;
    Summary frameSeconds;
    /// How lights count; none without a threshold.
    struct Lists {
        double threshold = 0.0;  ///< Nits.
        /// Lights and groups in a tile's list, mean over all tiles; none where all were lit by.
        std::optional<double> lightsPerTile;
        /// Lights that alone add more than the threshold to a pixel, mean over those that show a
        /// surface; by a small picture of each n-th light.
        double lightsAboveThreshold = 0.0;
    };
    std::optional<Lists> lists;
    std::size_t peakMemoryBytes = 0;  ///< Of the process while it read and drew this scene.
    std::vector<PassResult> passes;
};

/// Starts the count of peakMemoryBytes() anew, so that it is of what comes; false where the system
/// can't, and it goes on from the process's start.
bool beginPeakMemory();
std::size_t peakMemoryBytes();

/// Draws `repeatCount` frames of `scene`, after one that compiles, with `context` current. Fills
/// all but the name. Throws Error where OpenGL reports one.
SceneResult runSceneBench(Context& context, const scene::Scene& scene, const scene::Camera& camera,
                          const RenderOptions& options, int repeatCount, Clock clock,
                          Progress& progress);

}  // namespace polylume::bench
