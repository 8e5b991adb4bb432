// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// How far a table's lobes are from the BRDF: mean of integral |f cos - albedo D / H| / (true
/// albedo) over the upper hemisphere, 0 (the same) to about 2 (apart), for r from 0.05 to 1 and
/// theta_v from 0 to 85 degrees.
struct TableScore {
    double atNodes = 0.0;  ///< Over the nodes in that range.
    double betweenNodes =
        0.0;             ///< Over a grid uniform in r and theta_v, looked up as a shader does.
    double worst = 0.0;  ///< The largest value on that grid.
    double albedoError = 0.0;  ///< The largest error of the albedo that is looked up on that grid.
};

/// Scores `table` on a grid of `gridSize` x `gridSize` points, at least 2. Deterministic; calls
/// `brdf` from several threads at once.
TableScore scoreTable(const brdf::Brdf& brdf, const ltc::Table& table, int gridSize = 40);

/// The integral above for one roughness and view angle and one entry of a table.
double scoreEntry(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                  const ltc::TableEntry& entry);

}  // namespace polylume::fit
