// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <string_view>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume {

/// More than any texture or picture of ours, and far less than what a forged header can ask for.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 28;

/// Throws Error that names `name` when there are no pixels, or too many.
inline void checkPixelCount(long long width, long long height, int channelCount,
                            std::string_view name) {
    const bool isRight = width > 0 && height > 0 && channelCount > 0 &&
                         width <= static_cast<long long>(kMostPixels) / height;
    if (isRight) return;
    throw Error(concat("can't read ", name, ": expected 1 to ", kMostPixels, " pixels, found ",
                       width, "x", height, " of ", channelCount, " channels"));
}

}  // namespace polylume
