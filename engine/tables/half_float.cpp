// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/half_float.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polylume::tables {
namespace {

constexpr int kFractionBits = 10;
constexpr int kLeastExponent = -14;  // Of a normal number.
constexpr int kMostExponent = 15;
constexpr std::uint16_t kInfinity = 0x7c00;
constexpr std::uint16_t kSign = 0x8000;

}  // namespace

std::uint16_t halfOf(float value) {
    const std::uint16_t sign = std::signbit(value) ? kSign : 0;
    if (std::isnan(value)) return sign | kInfinity | 1;
    const double magnitude = std::abs(static_cast<double>(value));
    int exponent = kLeastExponent;
    if (magnitude > 0.0 && std::isfinite(magnitude)) {
        exponent = std::max(std::ilogb(magnitude), kLeastExponent);
    }
    if (!std::isfinite(magnitude) || exponent > kMostExponent) return sign | kInfinity;
    // In units of the last place; a carry out of the fraction raises the exponent by itself.
    const int units =
        static_cast<int>(std::nearbyint(std::ldexp(magnitude, kFractionBits - exponent)));
    const int bits = ((exponent - kLeastExponent) << kFractionBits) + units;
    return static_cast<std::uint16_t>(sign | bits);
}

float floatOf(std::uint16_t half) {
    const int exponentBits = half >> kFractionBits & 0x1f;
    const int fraction = half & ((1 << kFractionBits) - 1);
    const float sign = (half & kSign) != 0 ? -1.0f : 1.0f;
    if (exponentBits == 0x1f) {
        return fraction != 0 ? std::numeric_limits<float>::quiet_NaN()
                             : sign * std::numeric_limits<float>::infinity();
    }
    const int units = exponentBits > 0 ? fraction + (1 << kFractionBits) : fraction;
    const int exponent = exponentBits > 0 ? exponentBits - 1 + kLeastExponent : kLeastExponent;
    return sign * std::ldexp(static_cast<float>(units), exponent - kFractionBits);
}

}  // namespace polylume::tables
