// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <vector>

#include "brdf/brdf.hpp"
#include "core/progress.hpp"
#include "fit/polygon_score.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// Mean and largest of some errors.
struct ErrorSummary {
    double mean = 0.0;
    double largest = 0.0;
};

/// What a table's lobes are worth over some places. With f = BRDF times cosine and m the model,
/// both over the upper hemisphere:
struct LobeErrors {
    ErrorSummary l1;             ///< integral |f - m| / integral f
    ErrorSummary l2;             ///< sqrt(integral (f - m)^2 / integral f^2)
    ErrorSummary leak;           ///< The share of the lobes below the surface: 1 - H for one.
    double polygonMean = 0.0;    ///< Of |m - f| / f over random rectangles (PolygonErrors).
    double polygonOfSums = 0.0;  ///< The sum of |m - f| over that of f, over the same rectangles.
    int polygonCount = 0;        ///< How many those are.
};

/// The errors of what a table stores besides its lobes, absolute.
struct ReflectanceErrors {
    ErrorSummary albedo;
    ErrorSummary fresnel;
};

/// The score at one roughness, or of a whole table.
struct ScoreRow {
    double roughness = 0.0;
    LobeErrors lobesAtNodes;
    LobeErrors lobesBetweenNodes;
    ReflectanceErrors reflectanceAtNodes;
    ReflectanceErrors reflectanceBetweenNodes;
    ReflectanceErrors reflectanceGrazing;  ///< Between nodes, up to kMostGrazingDegrees.
};

inline constexpr double kMostGrazingDegrees = 89.5;

/// "Between nodes" is the grid of score_grid.hpp, looked up as a shader does; "at nodes" is the
/// nodes nearest to it.
struct FullScore {
    std::vector<ScoreRow> rows;  ///< By growing roughness; one for a table of one column.
    ScoreRow overall;  ///< Means over all places of all rows; its roughness means nothing.
};

struct FullScoreOptions {
    int resolution = 160;     ///< Of the rule that f is integrated with (Brdf::quadrature()).
    int rectangleCount = 16;  ///< At each place, so some 10000 for a table.
    std::uint64_t seed = 1;
    int threadCount = 0;  ///< At most this many threads; 0: one per processor. Changes no value.
};

/// Scores `table` against `brdf`, which is called from several threads at once. The same on every
/// run and for any number of threads. Throws Error where the BRDF reflects nothing somewhere.
FullScore computeFullScore(const brdf::Brdf& brdf, const ltc::Table& table,
                           const FullScoreOptions& options, Progress& progress);

/// The errors of one entry at one place, with its own rectangles.
LobeErrors placeErrors(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                       const ltc::TableEntry& entry, const FullScoreOptions& options);

}  // namespace polylume::fit
