// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <optional>
#include <span>

#include "lighting/light_summary.hpp"
#include "shared/light_data.h"

namespace polylume {

/// How some lights are spread about a point: what bounds the error of taking them for a point.
struct LightSpread {
    glm::dvec3 center{0.0};  ///< Of their flux, as float has it.
    double radius = 0.0;     ///< Of a sphere about it that holds them.
    /// Frobenius norms of the moments of radiance about the center, by order from 1, of the channel
    /// where each is largest: nits metres^(2 + order).
    std::array<double, 3> moments{};
    double fourthMoment = 0.0;  ///< At most.
};

/// Nothing for lights with images, tubes and lights without extent, and where there is no flux.
std::optional<LightSpread> spreadOf(std::span<const LightSummary> lights);

/// A parallelogram that stands for several flat lights of about the same plane, as they are seen
/// from afar: of the same flux, with its center and its second moments where those of the flux are.
struct LightGroup {
    shared::ParallelogramData parallelogram{};
    double radius = 0.0;  ///< Of a sphere about the lights' center that holds it.
    /// Norms as above of the differences between its moments and its lights', by order from 0.
    std::array<double, 4> differences{};
    double fourthMoment = 0.0;  ///< At most, of both together.
};

/// Nothing where no group can stand for `lights`, which have that spread: where one is not flat.
/// Their normals differ by shared::kParallelTolerance at most.
std::optional<LightGroup> groupLights(std::span<const LightSummary> lights,
                                      const LightSpread& spread);

}  // namespace polylume
