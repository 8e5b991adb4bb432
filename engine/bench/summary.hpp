// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

namespace polylume::bench {

/// What repeated measurements of one thing came to.
struct Summary {
    double median = 0.0;
    double lowerQuartile = 0.0;  ///< A quarter of them is below,
    double upperQuartile = 0.0;  ///< a quarter above.
    double least = 0.0;
    double most = 0.0;
};

/// Quartiles lie between two values by linear interpolation. Zeros where there are no `values`.
Summary summarize(std::vector<double> values);

}  // namespace polylume::bench
