// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/color_map.hpp"

#include <gtest/gtest.h>

namespace polylume {
namespace {

TEST(ColorMap, lightnessGrowsEvenly) {
    const double first = lightness(heatColor(0.0));
    const double last = lightness(heatColor(1.0));
    EXPECT_NEAR(first, 8.0, 1.0);
    EXPECT_NEAR(last, 95.0, 1.0);
    for (int i = 0; i <= 100; ++i) {
        // Rounding to 8 bits moves dark colours by about a step of L*.
        EXPECT_NEAR(lightness(heatColor(i / 100.0)), first + (last - first) * i / 100.0, 1.2) << i;
    }
}

TEST(ColorMap, lightnessOfKnownColors) {
    EXPECT_NEAR(lightness({255, 255, 255}), 100.0, 1e-2);
    EXPECT_NEAR(lightness({0, 0, 0}), 0.0, 1e-9);
    EXPECT_NEAR(lightness({119, 119, 119}), 50.0, 0.2);  // Middle grey.
    EXPECT_NEAR(lightness({255, 0, 0}), 53.2, 0.2);
}

TEST(ColorMap, valuesBeyondTheEndsAreThoseOfTheEnds) {
    EXPECT_EQ(heatColor(-1.0), heatColor(0.0));
    EXPECT_EQ(heatColor(7.0), heatColor(1.0));
}

}  // namespace
}  // namespace polylume
