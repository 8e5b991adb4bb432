// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <vector>

#include "fit/lobe_samples.hpp"
#include "ltc/table_layout.hpp"

namespace polylume::fit {

/// A place where a node's error counts: at the node itself, or between it and others, where a
/// lookup blends them.
struct FitTerm {
    const LobeSamples* samples;
    ltc::LobeAxis axis;
    double weight = 1.0;
    double share = 1.0;     ///< The node's weight in the blend.
    ltc::TableNode others;  ///< What the other nodes add to the blend: the sum of theirs by weight.
};

/// Which lobes may come out: any, or those that are round about the normal, as an isotropic BRDF's
/// are for a view along it.
enum class LobeFreedom { any, round };

/// What is asked of one node besides its terms.
struct NodeGoal {
    int lobeCount = 1;
    LobeFreedom freedom = LobeFreedom::any;
    double smoothing = 0.02;  ///< s in the stand-in for the L1 distance, below.
    /// Nodes that it should be near, and how much that counts: the square of the distance in log
    /// stretch, tilt over width, shear, log rootWidth and logit of the share.
    std::vector<ltc::TableNode> wishes;
    double smoothness = 0.0;
};

/// Moves `start` to a local minimum of the sum over terms of
///   weight * integral of target * (sqrt(q^2 + s^2) - s), q = model / target - 1,
/// a smooth stand-in for the L1 distance, by Levenberg-Marquardt (Ceres' TinySolver) with exact
/// derivatives. Never worse than `start`, but for the lobes being made round first. albedo, fresnel
/// and color are left as they are. The last term is the node's own place.
ltc::TableNode fitNode(const ltc::TableNode& start, std::span<const FitTerm> terms,
                       const NodeGoal& goal);

/// Whether the lobes are within what float32 and a lookup stand, and not all but below the surface,
/// where the shape of what is left above would be nearly free. What fitNode() starts from has to
/// be.
bool isUsable(const ltc::TableNode& node, int lobeCount, const ltc::LobeAxis& axis);

/// Adds `weight` times the stored lobes of `node` to `sum`.
void addLobes(ltc::TableNode& sum, const ltc::TableNode& node, double weight);

/// A node all of whose stored lobes are 0, to add to.
ltc::TableNode zeroNode();

}  // namespace polylume::fit
