// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/pixel_samples.hpp"

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
    std::vector<glm::dvec2> samples;
    // Half a cell further, so that their mean tends to the centre and a single one is the centre.
    const double half = 0.5 / count;
    // The sequence's own mean falls short of a half by less than half a cell, by an amount known
    // only from its sum.
    double meanY = 0.0;
    for (int i = 0; i < count; ++i) meanY += radicalInverse(static_cast<unsigned>(i)) / count;
    for (int i = 0; i < count; ++i) {
        samples.emplace_back(static_cast<double>(i) / count + half,
                             radicalInverse(static_cast<unsigned>(i)) + 0.5 - meanY);
    }
    return samples;
}

}  // namespace polylume
