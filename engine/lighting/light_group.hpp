// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <optional>
#include <span>

#include "lighting/light_summary.hpp"
#include "shared/light_data.h"

namespace polylume {

/// A parallelogram that stands for several flat lights of about the same plane, as they are seen
/// from afar: of the same flux, with its center and its second moments where those of the flux are.
struct LightGroup {
    shared::ParallelogramData parallelogram{};
    glm::dvec3 center{0.0};  ///< Of the flux, as float has it.
    double radius = 0.0;     ///< Of a sphere about it that holds the parallelogram.
    /// Frobenius norms of the differences between its moments of radiance about the center and its
    /// lights', by order from 0, of the channel where each is largest: nits metres^(2 + order).
    std::array<double, 4> differences{};
    double fourthMoment = 0.0;  ///< At most, of both together.
};

/// Nothing where no group can stand for `lights`: where one is not flat or has an image, and where
/// there is no flux. Their normals differ by shared::kParallelTolerance at most.
std::optional<LightGroup> groupLights(std::span<const LightSummary> lights);

}  // namespace polylume
