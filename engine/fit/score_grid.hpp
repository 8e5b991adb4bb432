// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "ltc/table.hpp"

namespace polylume::fit {

/// Where tables are scored: perceptual roughness from kLeastScoredRoughness to 1, views from the
/// normal to kMostScoredDegrees from it.
inline constexpr double kLeastScoredRoughness = 0.05;
inline constexpr double kMostScoredDegrees = 85.0;

/// How many places: they are 0.05 of roughness and 2.5 degrees apart.
inline constexpr int kScoredRoughnessCount = 20;
inline constexpr int kScoredViewCount = 35;

/// One roughness and view that a table is looked up at.
struct ScorePlace {
    double roughness = 0.0;
    double cosThetaView = 1.0;
};

/// Cosine of an angle in degrees.
double cosDegrees(double degrees);

/// `count` roughnesses, at least 2, evenly spaced over the range above; for a table of one column
/// its own alone: what its attribute "roughness" says, else 0.
std::vector<double> scoredRoughnesses(const ltc::Table& table, int count);

/// `count` views, at least 2, evenly spaced by angle from `firstDegrees` to `lastDegrees`.
std::vector<double> scoredViews(double firstDegrees, double lastDegrees, int count);

/// The nodes next to the places of one roughness: each node once, within the range above.
std::vector<ScorePlace> nodesNear(const ltc::Table& table, double roughness,
                                  const std::vector<double>& cosThetaViews);

}  // namespace polylume::fit
