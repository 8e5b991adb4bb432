// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"
#include "core/progress.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// How lobes are found. `moments`: in closed form, in a second or two. `lm`: Levenberg-Marquardt
/// from there, with about half the error.
enum class Solver { moments, lm };

struct FitOptions {
    Solver solver = Solver::lm;
    int lobeCount = 1;  ///< 1 or 2.
    int size = 64;      ///< Nodes along each axis, 2 to 1024.
    /// One column alone, of the roughness `viewRoughness`. A BRDF without roughness has no other
    /// tables.
    bool viewOnly = false;
    double viewRoughness = 0.5;
    int resolution =
        32;  ///< Of the rule that a lobe is fitted on (Brdf::quadrature()), at least 8.
    int threadCount = 0;  ///< At most this many threads; 0: one per processor. Changes no value.
};

/// Fits a table to `brdf`, with its score among the attributes. The same bytes on every run and for
/// any number of threads; `brdf` is called from several threads at once. Throws Error for options
/// out of range.
ltc::Table fitTable(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress);

}  // namespace polylume::fit
