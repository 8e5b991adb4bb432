// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "image/image.hpp"

namespace polylume::test {

/// How far two pictures may be apart.
struct Tolerance {
    /// Of a channel's value, or of the reference's mean where that is larger; 0: bit for bit.
    double relative = 0.0;
    /// The share of pixels that may be off all the same (silhouettes fall on the other side of a
    /// pixel).
    double outlierShare = 0.0;
};

/// Why `image` does not match `reference`; empty where it does. Sizes, channel names and finiteness
/// come first; then the message has the number of pixels that differ and the worst one.
std::string compareImages(const FloatImage& image, const FloatImage& reference,
                          const Tolerance& tolerance);

/// The absolute difference of two pictures of one size and layout.
FloatImage differenceOf(const FloatImage& image, const FloatImage& reference);

}  // namespace polylume::test
