// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/half_float.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace polylume::tables {
namespace {

TEST(HalfFloat, everyHalfComesBack) {
    for (int bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const float value = floatOf(half);
        if (std::isnan(value)) {
            EXPECT_TRUE(std::isnan(floatOf(halfOf(value))));
            continue;
        }
        ASSERT_EQ(halfOf(value), half);
    }
}

TEST(HalfFloat, knownValues) {
    EXPECT_EQ(halfOf(1.0f), 0x3c00);
    EXPECT_EQ(halfOf(-2.0f), 0xc000);
    EXPECT_EQ(halfOf(65504.0f), 0x7bff);               // The largest.
    EXPECT_EQ(halfOf(std::ldexp(1.0f, -24)), 0x0001);  // The least.
    EXPECT_EQ(halfOf(0.333333343f), 0x3555);           // IEEE 754 1/3.
    EXPECT_EQ(halfOf(65520.0f), 0x7c00);               // Rounds up to infinity.
    EXPECT_EQ(halfOf(std::numeric_limits<float>::max()), 0x7c00);
    EXPECT_EQ(halfOf(-std::numeric_limits<float>::infinity()), 0xfc00);
    EXPECT_EQ(halfOf(-0.0f), 0x8000);
}

TEST(HalfFloat, roundsToTheNearestAndTiesToEven) {
    const float unit = std::ldexp(1.0f, -10);
    EXPECT_EQ(halfOf(1.0f + 0.5f * unit), 0x3c00);
    EXPECT_EQ(halfOf(1.0f + 1.5f * unit), 0x3c02);
    EXPECT_EQ(halfOf(1.0f + 0.51f * unit), 0x3c01);
    EXPECT_EQ(halfOf(2.0f - 0.25f * unit), 0x4000);  // Carries into the exponent.
    EXPECT_EQ(halfOf(std::ldexp(0.5f, -24)), 0x0000);
    EXPECT_EQ(halfOf(std::ldexp(0.51f, -24)), 0x0001);
}

}  // namespace
}  // namespace polylume::tables
