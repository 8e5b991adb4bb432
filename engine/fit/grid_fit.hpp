// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <vector>

#include "brdf/brdf.hpp"
#include "fit/lobe_samples.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// The grid of nodes that is fitted, and how its nodes are stored.
struct GridPlan {
    ltc::TableSize size;
    ltc::TableLayout layout;
    int resolution = 32;  ///< Of the rule that lobes are fitted on (Brdf::quadrature()).

    double viewRoughness = 0.0;  ///< The roughness of a single column.

    double roughness(double column) const {
        return size.columns == 1 ? viewRoughness : column / (size.columns - 1);
    }
    double cosThetaView(double row) const;
    ltc::LobeAxis axis(double column, double row) const;
    std::size_t nodeCount() const { return static_cast<std::size_t>(size.columns) * size.rows; }
};

/// Called once for each of a run's equal steps, from any thread.
using StepCallback = std::function<void()>;

/// The lobes of all nodes, row by row, in closed form (momentNode()). Takes size.columns steps.
std::vector<ltc::TableNode> fitGridByMoments(const brdf::Brdf& brdf, const GridPlan& plan,
                                             const StepCallback& step);

/// How many steps fitGrid() takes.
int fitGridStepCount(const GridPlan& plan);

/// The lobes of all nodes by fitNode(): the middle column from the normal view on, then column by
/// column to both sides, every node from what its neighbour ended with, so that lobes change
/// smoothly; then sweeps that move each node to where it and the cells around it, as lookups blend
/// them, are best, with a wish for smoothness along both axes. Values don't depend on the number of
/// threads.
std::vector<ltc::TableNode> fitGrid(const brdf::Brdf& brdf, const GridPlan& plan,
                                    const StepCallback& step);

/// A single node by fitNode() as it is best alone, of several starts: the limit of the lobes.
ltc::TableNode fitAlone(const LobeSamples& samples, const ltc::TableLayout& layout,
                        const ltc::LobeAxis& axis, bool isNormalView);

}  // namespace polylume::fit
