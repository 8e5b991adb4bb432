// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace polylume::compare {

/// One value a pixel, row by row from the top.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;  ///< width * height

    Plane() = default;
    Plane(int planeWidth, int planeHeight);
    float* row(int y) { return values.data() + static_cast<std::size_t>(y) * width; }
    const float* row(int y) const { return values.data() + static_cast<std::size_t>(y) * width; }
};

/// A filter along one direction, kept as the half that its symmetry leaves.
struct Kernel {
    enum class Kind {
        smooth,     ///< Even: center p(0) + sum of sides[d - 1] (p(d) + p(-d)).
        slope,      ///< Odd: sum of sides[d - 1] (p(d) - p(-d)).
        curvature,  ///< Even, of sum 0: sum of sides[d - 1] (p(d) + p(-d) - 2 p(0)).
    };
    Kind kind = Kind::smooth;
    float center = 0.0f;  ///< For `smooth` alone.
    std::vector<float> sides;
};

/// exp(-x^2 / (2 sigma^2)) at -radius to radius, of sum 1. All lengths in pixels.
Kernel gaussianKernel(double sigma, int radius);
/// The Gaussian's slope, its positive weights of sum 1. On what is constant it gives exactly 0.
Kernel slopeKernel(double sigma, int radius);
/// The Gaussian's second derivative, its positive weights scaled to sum 1 and its negative ones to
/// sum -1. On what is constant it gives exactly 0.
Kernel curvatureKernel(double sigma, int radius);

/// Filters along rows or along columns; beyond the border the plane goes on with its border's
/// values.
Plane filterRows(const Plane& plane, const Kernel& kernel);
Plane filterColumns(const Plane& plane, const Kernel& kernel);

/// Calls `work` for each row, on several threads at once.
void forEachRow(int height, const std::function<void(int)>& work);

}  // namespace polylume::compare
