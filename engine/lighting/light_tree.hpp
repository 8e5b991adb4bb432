// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <vector>

#include "lighting/light_summary.hpp"
#include "shared/light_data.h"
#include "shared/light_list_data.h"

namespace polylume {

/// A tree over the lights of each kind, as passes/light_lists.comp goes through them.
struct LightTree {
    /// Depth first, kind after kind in the order of shared/light_list_data.h.
    std::vector<shared::LightNodeData> nodes;
    std::array<std::uint32_t, shared::kListKindCount> nodeEnds{};  ///< Of each kind.
    std::vector<shared::ParallelogramData> groups;
};

/// Groups get their indices from `firstGroup` on.
LightTree buildLightTree(std::vector<LightSummary> lights, std::uint32_t firstGroup);

}  // namespace polylume
