// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/plane_filter.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace polylume::compare {
namespace {

double gaussian(int x, double sigma) {
    return std::exp(-0.5 * x * x / (sigma * sigma));
}

/// Adds one pair of weights' share to a row: `before` and `after` lie the same number of pixels on
/// either side of `middle`. No branch inside the loops, so that they become vector code.
void addPair(Kernel::Kind kind, float weight, const float* before, const float* middle,
             const float* after, int count, float* sums) {
    switch (kind) {
        case Kernel::Kind::smooth:
            for (int x = 0; x < count; ++x) sums[x] += weight * (after[x] + before[x]);
            break;
        case Kernel::Kind::slope:
            for (int x = 0; x < count; ++x) sums[x] += weight * (after[x] - before[x]);
            break;
        case Kernel::Kind::curvature:
            for (int x = 0; x < count; ++x) {
                sums[x] += weight * ((after[x] - middle[x]) + (before[x] - middle[x]));
            }
            break;
    }
}

}  // namespace

Plane::Plane(int planeWidth, int planeHeight)
    : width(planeWidth),
      height(planeHeight),
      values(static_cast<std::size_t>(planeWidth) * static_cast<std::size_t>(planeHeight)) {}

Kernel gaussianKernel(double sigma, int radius) {
    double sum = 1.0;
    for (int x = 1; x <= radius; ++x) sum += 2.0 * gaussian(x, sigma);
    Kernel kernel;
    kernel.center = static_cast<float>(1.0 / sum);
    for (int x = 1; x <= radius; ++x) {
        kernel.sides.push_back(static_cast<float>(gaussian(x, sigma) / sum));
    }
    return kernel;
}

Kernel slopeKernel(double sigma, int radius) {
    double sum = 0.0;
    for (int x = 1; x <= radius; ++x) sum += x * gaussian(x, sigma);
    Kernel kernel;
    kernel.kind = Kernel::Kind::slope;
    for (int x = 1; x <= radius; ++x) {
        kernel.sides.push_back(static_cast<float>(x * gaussian(x, sigma) / sum));
    }
    return kernel;
}

Kernel curvatureKernel(double sigma, int radius) {
    const auto weight = [&](int x) { return (x * x / (sigma * sigma) - 1.0) * gaussian(x, sigma); };
    double positive = 0.0;
    double negative = 1.0;  // That of the middle, x = 0.
    for (int x = 1; x <= radius; ++x) {
        (weight(x) > 0.0 ? positive : negative) += 2.0 * std::abs(weight(x));
    }
    Kernel kernel;
    kernel.kind = Kernel::Kind::curvature;
    for (int x = 1; x <= radius; ++x) {
        kernel.sides.push_back(
            static_cast<float>(weight(x) / (weight(x) > 0.0 ? positive : negative)));
    }
    return kernel;
}

Plane filterRows(const Plane& plane, const Kernel& kernel) {
    Plane result(plane.width, plane.height);
    const int radius = static_cast<int>(kernel.sides.size());
    forEachRow(plane.height, [&](int y) {
        // The row with its ends repeated.
        const float* row = plane.row(y);
        std::vector<float> padded(static_cast<std::size_t>(plane.width) + 2 * kernel.sides.size());
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, plane.width, padded.begin() + radius);
        std::fill_n(padded.end() - radius, radius, row[plane.width - 1]);
        const float* middle = padded.data() + radius;
        float* sums = result.row(y);
        for (int x = 0; x < plane.width; ++x) sums[x] = kernel.center * middle[x];
        for (int d = 1; d <= radius; ++d) {
            addPair(kernel.kind, kernel.sides[static_cast<std::size_t>(d) - 1], middle - d, middle,
                    middle + d, plane.width, sums);
        }
    });
    return result;
}

Plane filterColumns(const Plane& plane, const Kernel& kernel) {
    Plane result(plane.width, plane.height);
    const int radius = static_cast<int>(kernel.sides.size());
    forEachRow(plane.height, [&](int y) {
        const float* middle = plane.row(y);
        float* sums = result.row(y);
        for (int x = 0; x < plane.width; ++x) sums[x] = kernel.center * middle[x];
        for (int d = 1; d <= radius; ++d) {
            addPair(kernel.kind, kernel.sides[static_cast<std::size_t>(d) - 1],
                    plane.row(std::max(y - d, 0)), middle,
                    plane.row(std::min(y + d, plane.height - 1)), plane.width, sums);
        }
    });
    return result;
}

void forEachRow(int height, const std::function<void(int)>& work) {
    tbb::parallel_for(0, height, work);
}

}  // namespace polylume::compare
