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
    /// Lights that are evaluated for a pixel, mean over those that show a surface; none where no
    /// light is left out.
    std::optional<double> lightsPerPixel;
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
