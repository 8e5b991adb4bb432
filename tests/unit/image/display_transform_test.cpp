// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/display_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <glm/glm.hpp>
#include <random>

namespace polylume {
namespace {

constexpr ToneMap kToneMaps[] = {ToneMap::none, ToneMap::reinhard, ToneMap::aces, ToneMap::neutral};
constexpr float kHuge = std::numeric_limits<float>::max();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// The EV at which nits are display-linear values.
const double kUnitEv = std::log2(1.0 / 1.2);

FloatImage makeImage(const std::vector<std::array<float, 4>>& pixels) {
    FloatImage image;
    image.width = static_cast<int>(pixels.size());
    image.height = 1;
    image.channelNames = {"R", "G", "B", "A"};
    for (const auto& pixel : pixels)
        image.pixels.insert(image.pixels.end(), pixel.begin(), pixel.end());
    return image;
}

/// The grey that a picture shows for display-linear `value`.
int shown(float value, ToneMap toneMap) {
    return displayImage(makeImage({{value, value, value, 1}}), kUnitEv, toneMap, false).pixels[0];
}

/// IEC 61966-2-1 in double, rounded to 8 bits.
int encoded(double linear) {
    const double value =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::lround(255.0 * value));
}

TEST(DisplayTransformTest, exposureFollowsTheEv) {
    EXPECT_DOUBLE_EQ(exposureScale(0.0), 1.0 / 1.2);
    EXPECT_DOUBLE_EQ(exposureScale(15.0), 1.0 / (1.2 * 32768.0));
    EXPECT_DOUBLE_EQ(exposureScale(-2.0), 4.0 * exposureScale(0.0));
}

TEST(DisplayTransformTest, exposureComesBeforeTheToneMap) {
    const FloatImage image = makeImage({{2400, 2400, 2400, 1}});
    for (const ToneMap toneMap : kToneMaps) {
        // 2400 / (1.2 * 2^12) = 0.48828125
        EXPECT_EQ(displayImage(image, 12.0, toneMap, false).pixels[0], shown(0.48828125f, toneMap));
    }
}

TEST(DisplayTransformTest, automaticExposurePutsTheLogMeanAtMiddleGrey) {
    for (const double nits : {1e-3, 1.0, 250.0, 1e6}) {
        EXPECT_NEAR(nits * exposureScale(evForLogMean(nits)), 0.18, 1e-12);
    }
}

TEST(DisplayTransformTest, logMeanCountsTheWantedPixelsAlone) {
    FloatImage image = makeImage({{10, 10, 10, 1}, {1000, 1000, 1000, 1}, {7, 7, 7, 1}});
    // 0.2126 + 0.7152 + 0.0722 = 1, in float.
    EXPECT_NEAR(logMeanLuminance(image, {true, true, false}), 100.0, 1e-4);
    EXPECT_NEAR(logMeanLuminance(image, {false, false, true}), 7.0, 1e-5);
    EXPECT_EQ(logMeanLuminance(image, {false, false, false}), 0.0);
    // Black has no logarithm.
    image.pixels[0] = image.pixels[1] = image.pixels[2] = 0.0f;
    EXPECT_NEAR(logMeanLuminance(image, {true, true, false}), 1000.0, 1e-3);
    EXPECT_EQ(logMeanLuminance(image, {true, false, false}), 0.0);
}

TEST(DisplayTransformTest, luminanceIsThatOfRec709) {
    const FloatImage image = makeImage({{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}});
    EXPECT_NEAR(logMeanLuminance(image, {true, false, false}), 0.2126, 1e-7);
    EXPECT_NEAR(logMeanLuminance(image, {false, true, false}), 0.7152, 1e-7);
    EXPECT_NEAR(logMeanLuminance(image, {false, false, true}), 0.0722, 1e-7);
}

TEST(DisplayTransformTest, logMeanSkipsFurtherChannels) {
    FloatImage image;
    image.width = 2;
    image.height = 1;
    image.channelNames = {"R", "G", "B", "A", "depth.Z"};
    image.pixels = {4, 4, 4, 1, 99, 9, 9, 9, 1, 99};
    EXPECT_NEAR(logMeanLuminance(image, {true, true}), 6.0, 1e-5);
}

TEST(DisplayTransformTest, encodesAsSrgb) {
    EXPECT_EQ(shown(0.0f, ToneMap::none), 0);
    EXPECT_EQ(shown(1.0f, ToneMap::none), 255);
    EXPECT_EQ(shown(7.0f, ToneMap::none), 255);
    EXPECT_EQ(shown(0.5f, ToneMap::none), 188);
    EXPECT_EQ(shown(0.18f, ToneMap::none), 118);
    EXPECT_EQ(shown(0.002f, ToneMap::none), 7);  // The straight part: 255 * 12.92 * 0.002 = 6.6.
    for (int i = 0; i <= 1000; ++i) {
        const auto value = static_cast<float>(i / 1000.0);
        ASSERT_NEAR(shown(value, ToneMap::none), encoded(value), 0) << value;
    }
}

TEST(DisplayTransformTest, toneMapsHitTheirKnownValues) {
    // Reinhard et al. 2002, eq. 4, white at 8: L (1 + L / 64) / (1 + L).
    EXPECT_EQ(shown(1.0f, ToneMap::reinhard), encoded(0.5078125));
    EXPECT_EQ(shown(8.0f, ToneMap::reinhard), 255);
    // Narkowicz 2015 at x = 0.722: x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14).
    EXPECT_EQ(shown(1.0f, ToneMap::aces), encoded(0.7257506));
    // On that scale middle grey stays.
    EXPECT_EQ(shown(0.18f, ToneMap::aces), encoded(0.18));
    // Khronos Neutral: 1 loses 0.04, of which the part over 0.76 is compressed to 1 - 0.0576 /
    // 0.44.
    EXPECT_EQ(shown(1.0f, ToneMap::neutral), encoded(1.0 - 0.0576 / 0.44));
    EXPECT_EQ(shown(0.5f, ToneMap::neutral), encoded(0.46));
}

TEST(DisplayTransformTest, toneMapsStartAtBlackAndNeverFall) {
    for (const ToneMap toneMap : kToneMaps) {
        EXPECT_EQ(shown(0.0f, toneMap), 0);
        int last = 0;
        for (int i = -80; i <= 300; ++i) {
            const int grey = shown(std::exp2(static_cast<float>(i) / 8.0f), toneMap);
            ASSERT_GE(grey, last) << i;
            last = grey;
        }
        EXPECT_EQ(last, 255);
    }
}

TEST(DisplayTransformTest, hugeValuesAreWhiteOrTheirColour) {
    for (const ToneMap toneMap : kToneMaps) {
        for (const float value : {1e10f, kHuge, kInfinity}) {
            EXPECT_EQ(shown(value, toneMap), 255) << value;
            // A NaN would come out as 0 or anything.
            const PixelImage picture =
                displayImage(makeImage({{value, 0, 0, 1}}), kUnitEv, toneMap, false);
            EXPECT_EQ(picture.pixels[0], 255) << value;
            EXPECT_EQ(picture.pixels[1], picture.pixels[2]) << value;
        }
    }
}

TEST(DisplayTransformTest, alphaIsTakenOutOfTheColour) {
    const FloatImage image = makeImage({{0.25f, 0.125f, 0, 0.5f}, {0, 0, 0, 0}, {0.5f, 0, 1, 1}});
    const PixelImage picture = displayImage(image, kUnitEv, ToneMap::none, true);
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 1);
    EXPECT_EQ(picture.channelCount, 4);
    const std::vector<std::uint8_t> expected = {
        188, static_cast<std::uint8_t>(encoded(0.25)), 0, 128, 0, 0, 0, 0, 188, 0, 255, 255};
    EXPECT_EQ(picture.pixels, expected);
}

TEST(DisplayTransformTest, withoutAlphaTheColourStands) {
    const FloatImage image = makeImage({{0.5f, 0.18f, 1, 0.5f}});
    const PixelImage picture = displayImage(image, kUnitEv, ToneMap::none, false);
    EXPECT_EQ(picture.channelCount, 3);
    const std::vector<std::uint8_t> expected = {188, 118, 255};
    EXPECT_EQ(picture.pixels, expected);
}

/// The most that a change of `nits` in some channels moves a value of a picture, in 8-bit steps,
/// over many colours: by differences of what two pictures show, in the finest that floats have.
int largestStep(ToneMap toneMap, double ev, double nits) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-14.0f, 3.0f);
    std::uniform_int_distribution<int> sign(0, 2);
    // Many pixels that only differ a little show by their rounding how far a value has moved.
    constexpr int kColors = 4000, kPhases = 16;
    FloatImage before, after;
    for (FloatImage* image : {&before, &after}) {
        image->width = kPhases;
        image->height = kColors;
        image->channelNames = {"R", "G", "B", "A"};
    }
    const double white = 1.0 / exposureScale(ev);
    for (int i = 0; i < kColors; ++i) {
        glm::dvec3 color(std::exp2(exponent(random)), std::exp2(exponent(random)),
                         std::exp2(exponent(random)));
        if (i % 3 == 0) color = glm::dvec3(color.r);
        const glm::dvec3 change(sign(random) - 1, sign(random) - 1, sign(random) - 1);
        for (int k = 0; k < kPhases; ++k) {
            const glm::dvec3 at = white * color * (1.0 + 0.002 * k);
            for (int c = 0; c < 3; ++c) {
                before.pixels.push_back(static_cast<float>(at[c]));
                after.pixels.push_back(static_cast<float>(std::max(at[c] + nits * change[c], 0.0)));
            }
            before.pixels.push_back(1.0f);
            after.pixels.push_back(1.0f);
        }
    }
    const PixelImage a = displayImage(before, ev, toneMap, false);
    const PixelImage b = displayImage(after, ev, toneMap, false);
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        largest = std::max(largest, std::abs(int(a.pixels[i]) - int(b.pixels[i])));
    }
    return largest;
}

TEST(DisplayTransformTest, aChangeOfHalfAStepMovesNoValueByMoreThanOne) {
    for (const ToneMap toneMap :
         {ToneMap::none, ToneMap::reinhard, ToneMap::aces, ToneMap::neutral}) {
        for (const double ev : {-3.0, 4.0, 12.0}) {
            const double nits = halfStepNits(ev, toneMap);
            EXPECT_LE(largestStep(toneMap, ev, nits), 1) << ev;
            // It is not far too small either.
            EXPECT_GE(largestStep(toneMap, ev, 5.0 * nits), 2) << ev;
        }
    }
}

}  // namespace
}  // namespace polylume
