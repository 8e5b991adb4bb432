// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/pixel_samples.hpp"

#include <algorithm>
#include <numeric>

namespace polylume {
namespace {

/// The van der Corput sequence: the bits of `index` mirrored at the binary point.
double radicalInverse(unsigned index) {
    double value = 0.0;
    for (double digit = 0.5; index != 0; index >>= 1, digit *= 0.5) {
        if (index & 1u) value += digit;
    }
    return value;
}

}  // namespace

std::vector<glm::dvec2> pixelSamples(int count) {
    // Rows in the order of the sequence. By their rank, not by its value, each row of the grid
    // holds one sample and their mean is the centre for every count, not for powers of two alone.
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [](int i) { return radicalInverse(static_cast<unsigned>(i)); });
    std::vector<glm::dvec2> samples(order.size());
    for (int row = 0; row < count; ++row) {
        const int column = order[static_cast<std::size_t>(row)];
        samples[static_cast<std::size_t>(column)] =
            (glm::dvec2(column, row) + 0.5) / static_cast<double>(count);
    }
    return samples;
}

}  // namespace polylume
