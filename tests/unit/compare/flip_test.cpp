// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/flip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flip_by_definition.hpp"
#include "image/color_map.hpp"
#include "pictures.hpp"

namespace polylume::compare {
namespace {

using test::flipByDefinition;
using test::flipOfFlatColors;
using test::makeFlat;
using test::makeNoise;
using test::meanOf;

// Single precision of values up to 1, cube roots and powers of them: below 1e-5 of the error's
// range in all that follows.
constexpr double kTolerance = 2e-5;

double flipOfFlat(const glm::vec3& a, const glm::vec3& b) {
    const Plane flip = displayFlip(makeFlat(9, 7, a), makeFlat(9, 7, b), kDefaultPixelsPerDegree);
    const auto [least, most] = std::minmax_element(flip.values.begin(), flip.values.end());
    EXPECT_NEAR(*least, *most, 1e-6);
    return flip.values[0];
}

TEST(Flip, equalPicturesDifferByNothing) {
    const ColorImage noise = makeNoise(40, 30, 1);
    const Plane flip = displayFlip(noise, noise, kDefaultPixelsPerDegree);
    for (const float value : flip.values) ASSERT_EQ(value, 0.0f);
    const FlipSummary summary = summarize(flip);
    EXPECT_EQ(summary.mean, 0.0);
    EXPECT_EQ(summary.weightedMedian, 0.0);
    EXPECT_EQ(summary.maximum, 0.0);
}

TEST(Flip, isTheSameEitherWayRound) {
    const ColorImage a = makeNoise(40, 30, 1);
    const ColorImage b = makeNoise(40, 30, 2);
    EXPECT_EQ(displayFlip(a, b, 67.0).values, displayFlip(b, a, 67.0).values);
}

TEST(Flip, flatColorsFollowTheClosedForm) {
    const glm::vec3 colors[] = {{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f},   {0.5f, 0.5f, 0.5f},
                                {1.0f, 0.0f, 0.0f}, {0.2f, 0.6f, 0.1f},   {0.21f, 0.6f, 0.1f},
                                {0.0f, 0.0f, 1.0f}, {0.01f, 0.02f, 0.03f}};
    for (const glm::vec3& a : colors) {
        for (const glm::vec3& b : colors) {
            EXPECT_NEAR(flipOfFlat(a, b), flipOfFlatColors(a, b), kTolerance);
        }
    }
}

TEST(Flip, greenAgainstBlueIsTheLargest) {
    EXPECT_NEAR(flipOfFlat({0, 1, 0}, {0, 0, 1}), 1.0, 1e-6);
    // 0.95 + 0.05 ((100 / 203.25)^0.7 - 0.4) / 0.6, as HyAB is 100 there and 203.25 above.
    EXPECT_NEAR(flipOfFlat({0, 0, 0}, {1, 1, 1}), 0.9674, 1e-4);
}

TEST(Flip, agreesWithThePaperPixelByPixel) {
    // Smaller than the filters, so that borders are met everywhere, and larger.
    for (const auto& [width, height] : {std::pair(7, 5), std::pair(40, 3), std::pair(33, 37)}) {
        const ColorImage a = makeNoise(width, height, 3);
        ColorImage b = makeNoise(width, height, 4);
        // Half as far from the first: errors on both sides of the scale's knee.
        for (std::size_t i = 0; i < b.pixels.size(); ++i) {
            b.pixels[i] = 0.5f * (a.pixels[i] + b.pixels[i]);
        }
        for (const double pixelsPerDegree : {20.0, 67.0}) {
            const Plane flip = displayFlip(a, b, pixelsPerDegree);
            for (int y = 0; y < height; y += 4) {
                for (int x = 0; x < width; x += 6) {
                    const double expected = flipByDefinition(a, b, x, y, pixelsPerDegree);
                    ASSERT_NEAR(flip.row(y)[x], expected, kTolerance) << x << ", " << y;
                    // The comparison can fail.
                    ASSERT_GT(std::abs(flip.row(y)[x] -
                                       flipByDefinition(a, b, x, y, 1.1 * pixelsPerDegree)),
                              kTolerance);
                }
            }
        }
    }
}

TEST(Flip, aSinglePixelIsAFlatPicture) {
    const glm::vec3 a(0.3f, 0.2f, 0.1f);
    const glm::vec3 b(0.3f, 0.25f, 0.1f);
    const Plane flip = displayFlip(makeFlat(1, 1, a), makeFlat(1, 1, b), 67.0);
    ASSERT_EQ(flip.values.size(), 1u);
    EXPECT_NEAR(flip.values[0], flipOfFlatColors(a, b), kTolerance);
}

/// Black up to a column, white from there.
ColorImage makeEdge(int column) {
    ColorImage image = makeFlat(64, 16, glm::vec3(0.0f));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (static_cast<int>(i) % 64 >= column) image.pixels[i] = glm::vec3(1.0f);
    }
    return image;
}

TEST(Flip, aMovedEdgeIsSeenWhereItIs) {
    const Plane flip = displayFlip(makeEdge(32), makeEdge(33), 67.0);
    const FlipSummary summary = summarize(flip);
    EXPECT_NEAR(summary.x, 32, 1);
    EXPECT_GT(summary.maximum, 0.3);
    // The filters reach 10 pixels.
    EXPECT_EQ(flip.row(8)[32 - 11], 0.0f);
    EXPECT_EQ(flip.row(8)[32 + 11], 0.0f);
    // A lost edge is more than a moved one.
    EXPECT_GT(meanOf(displayFlip(makeEdge(32), makeEdge(64), 67.0)), summary.mean);
}

TEST(Flip, growsWithNoise) {
    const ColorImage grey = makeFlat(48, 48, glm::vec3(0.4f));
    double last = 0.0;
    for (const float strength : {0.01f, 0.05f, 0.1f, 0.3f, 0.6f}) {
        ColorImage noisy = makeNoise(48, 48, 5, strength);
        for (glm::vec3& pixel : noisy.pixels) pixel += glm::vec3(0.4f - 0.5f * strength);
        const double mean = meanOf(displayFlip(noisy, grey, 67.0));
        EXPECT_GT(mean, 1.1 * last) << strength;
        last = mean;
    }
}

TEST(Flip, fineDetailVanishesWithDistance) {
    ColorImage checks = makeFlat(48, 48, glm::vec3(0.3f));
    for (std::size_t i = 0; i < checks.pixels.size(); ++i) {
        if ((i % 48 + i / 48) % 2 == 0) checks.pixels[i] = glm::vec3(0.5f);
    }
    const ColorImage grey = makeFlat(48, 48, glm::vec3(0.4f));
    const auto atMiddle = [&](double pixelsPerDegree) {
        return displayFlip(checks, grey, pixelsPerDegree).row(24)[24];
    };
    EXPECT_GT(atMiddle(10.0), 1.2f * atMiddle(20.0));
    EXPECT_GT(atMiddle(20.0), 1.2f * atMiddle(40.0));
    EXPECT_GT(atMiddle(40.0), 1.2f * atMiddle(67.0));
    EXPECT_LT(atMiddle(67.0), 0.01f);
}

TEST(FlipSummary, isOfTheValuesThemselves) {
    Plane flip(4, 2);
    flip.values = {0.0f, 0.1f, 0.1f, 0.0f, 0.2f, 0.6f, 0.0f, 0.6f};
    const FlipSummary summary = summarize(flip);
    EXPECT_NEAR(summary.mean, 0.2, 1e-7);
    EXPECT_NEAR(summary.maximum, 0.6, 1e-7);
    EXPECT_EQ(summary.x, 1);
    EXPECT_EQ(summary.y, 1);
    // 0.1 + 0.1 + 0.2 = 0.4 of 1.6 up to 0.2: half is reached in the first of 0.6.
    EXPECT_NEAR(summary.weightedMedian, 0.6, 1e-7);
    flip.values = {0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.1f, 0.3f};
    EXPECT_NEAR(summarize(flip).weightedMedian, 0.1, 1e-7);
}

TEST(FlipHeatMap, takesTheColorsOfTheErrors) {
    Plane flip(3, 1);
    flip.values = {0.0f, 0.5f, 1.0f};
    const PixelImage image = heatMap(flip);
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 1);
    ASSERT_EQ(image.channelCount, 3);
    const auto colorAt = [&](std::size_t x) {
        return Color{image.pixels[3 * x], image.pixels[3 * x + 1], image.pixels[3 * x + 2]};
    };
    EXPECT_EQ(colorAt(0), heatColor(0.0));
    EXPECT_EQ(colorAt(1), heatColor(128.0 / 255.0));
    EXPECT_EQ(colorAt(2), heatColor(1.0));
}

}  // namespace
}  // namespace polylume::compare
