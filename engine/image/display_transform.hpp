// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace polylume {

enum class ToneMap { none, reinhard, aces, neutral };

/// The scale from nits to display-linear values for an exposure value at ISO 100: 1 / (1.2 * 2^EV),
/// which maps the luminance that saturates a sensor (ISO 12232) to 1.
double exposureScale(double ev);

/// The EV that puts the log-mean luminance `nits` at 0.18.
double evForLogMean(double nits);

/// Half an 8-bit step, in nits, at exposure `ev`: a change of radiance, in any channels, up to this
/// size moves no value of displayImage() by more than half a step, before it is rounded, however
/// dark or coloured the pixel is.
double halfStepNits(double ev, ToneMap toneMap);

/// The log-mean luminance of the pixels where `weights` (one a pixel) is true and the luminance is
/// positive, summed in the order of storage; 0 where there is none. `radiance` begins with channels
/// R, G, B.
double logMeanLuminance(const FloatImage& radiance, const std::vector<bool>& weights);

/// An 8-bit sRGB picture of `radiance` (R, G, B, A in nits, colour times coverage): exposed,
/// tone-mapped, encoded. With `keepAlpha` RGBA with alpha not multiplied in, else RGB.
PixelImage displayImage(const FloatImage& radiance, double ev, ToneMap toneMap, bool keepAlpha);

}  // namespace polylume
