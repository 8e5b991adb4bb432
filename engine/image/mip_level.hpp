// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "image/image.hpp"

namespace polylume {

/// The next coarser mip level of `above`, of at least one pixel and at most half its size, rounded
/// down (OpenGL 4.5, section 8.14.3): each texel is `above`, filtered linearly, at the texel's
/// middle, which for even sizes is the mean of four. With `srgb` colours are averaged as the light
/// that they stand for; a second or fourth channel is alpha, which is linear always.
PixelImage nextMipLevel(const PixelImage& above, bool srgb);

}  // namespace polylume
