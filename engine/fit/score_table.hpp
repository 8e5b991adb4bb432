// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// How far a table's lobes are from the BRDF, at a glance: mean of integral |f cos - albedo lobes|
/// / (true albedo) over the upper hemisphere, 0 (the same) to about 2 (apart), over the range of
/// score_grid.hpp. FullScore tells more.
struct TableScore {
    double atNodes = 0.0;  ///< Over the nodes in that range.
    double betweenNodes =
        0.0;             ///< Over a grid uniform in r and theta_v, looked up as a shader does.
    double worst = 0.0;  ///< The largest value on that grid.
    double albedoError = 0.0;   ///< The largest error of the albedo that is looked up on that grid,
    double fresnelError = 0.0;  ///< and of the Fresnel-weighted albedo.
};

/// Scores `table` on a grid of `gridSize` x `gridSize` points, at least 2; a table of one column at
/// its own roughness alone. Deterministic; calls `brdf` from several threads at once.
TableScore scoreTable(const brdf::Brdf& brdf, const ltc::Table& table, int gridSize = 40);

/// The integral above for one roughness and view angle and one entry of a table.
double scoreEntry(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                  const ltc::TableEntry& entry);

}  // namespace polylume::fit
