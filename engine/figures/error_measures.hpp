// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "core/progress.hpp"
#include "image/image.hpp"

namespace polylume::figures {

/// How far an LTC picture is from a ray-traced one, in luminance, over the pixels that surfaces
/// cover wholly in both (A = 1).
struct ErrorMeasures {
    double meanRelative = 0.0;  ///< Mean of |LTC - truth| / truth, where the truth is above 0.
    double meanAbsolute = 0.0;  ///< Mean of |LTC - truth| over the mean of the truth.
    /// Root mean square of LTC - truth over the mean of the truth, without what the truth's noise
    /// adds to it (its mean squared standard error is taken out).
    double relativeRmse = 0.0;
    double bias = 0.0;  ///< Mean of LTC - truth over the mean of the truth.
    double flip = 0.0;  ///< Mean of HDR-FLIP at 67 pixels a degree.
    /// Root mean square of the truth's standard error over the mean of the truth; 0 where `truth`
    /// has no such layer.
    double noise = 0.0;
    int pixelCount = 0;
};

/// Both pictures are R, G, B, A and of one size; `truth` may have a layer standardError.
ErrorMeasures measureErrors(const FloatImage& ltc, const FloatImage& truth);

/// (LTC - truth) / truth in luminance at each pixel, row by row; 0 where it is not defined, NaN
/// where surfaces do not cover the pixel wholly.
std::vector<float> relativeDifference(const FloatImage& ltc, const FloatImage& truth);

}  // namespace polylume::figures
