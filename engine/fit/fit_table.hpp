// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "brdf/brdf.hpp"
#include "core/progress.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

struct FitOptions {
    int size = 64;  ///< Nodes along each axis, 2 to 1024.
    int resolution =
        32;  ///< Of the rule that a lobe is fitted on (Brdf::quadrature()), at least 8.
    int threadCount = 0;  ///< At most this many threads; 0: one per processor. Changes no value.
};

/// Fits a table of one lobe per roughness and view angle to `brdf`, with its score among the
/// attributes. The same bytes on every run and for any number of threads; `brdf` is called from
/// several threads at once. Throws Error for options out of range.
ltc::Table fitTable(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress);

/// The perceptual roughness of a column, and the cosine of the view angle of a row.
double columnRoughness(double column, int size);
double rowCosThetaView(double row, int size);

}  // namespace polylume::fit
