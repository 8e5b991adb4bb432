// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/mip_level.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

namespace polylume {
namespace {

PixelImage makeImage(int width, int height, int channelCount, std::vector<std::uint8_t> pixels) {
    PixelImage image;
    image.width = width;
    image.height = height;
    image.channelCount = channelCount;
    image.pixels = std::move(pixels);
    return image;
}

PixelImage make16(int width, int height, const std::vector<std::uint16_t>& values) {
    PixelImage image = makeImage(width, height, 1, std::vector<std::uint8_t>(2 * values.size()));
    image.bitsPerChannel = 16;
    std::memcpy(image.pixels.data(), values.data(), image.pixels.size());
    return image;
}

double decoded(double code) {
    const double value = code / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double encoded(double linear) {
    return 255.0 *
           (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

using Values = std::vector<std::uint8_t>;

TEST(MipLevelTest, linearValuesAreTheMeanOfFour) {
    const PixelImage level = nextMipLevel(makeImage(4, 2, 1, {1, 2, 10, 10, 3, 5, 10, 11}), false);
    EXPECT_EQ(level.width, 2);
    EXPECT_EQ(level.height, 1);
    EXPECT_EQ(level.channelCount, 1);
    EXPECT_EQ(level.pixels, (Values{3, 10}));  // Of 2.75 and 10.25.
}

TEST(MipLevelTest, oddSizesAreFilteredAtTheMiddle) {
    // The middle of 1 texel over 3 is the second; of 2 over 5, 0.75 and 3.25.
    EXPECT_EQ(nextMipLevel(makeImage(3, 1, 1, {9, 50, 200}), false).pixels, (Values{50}));
    EXPECT_EQ(nextMipLevel(makeImage(5, 1, 1, {0, 100, 0, 80, 40}), false).pixels,
              (Values{75, 70}));
    EXPECT_EQ(nextMipLevel(makeImage(1, 3, 1, {9, 50, 200}), false).pixels, (Values{50}));
}

TEST(MipLevelTest, colorsAreAveragedAsLightAndAlphaIsNot) {
    const PixelImage level =
        nextMipLevel(makeImage(2, 1, 4, {0, 0, 0, 0, 255, 255, 64, 255}), true);
    const auto half = static_cast<std::uint8_t>(std::lround(encoded(0.5)));
    const auto dark = static_cast<std::uint8_t>(std::lround(encoded(0.5 * decoded(64))));
    EXPECT_EQ(level.pixels, (Values{half, half, dark, 128}));
    EXPECT_EQ(half, 188);
}

TEST(MipLevelTest, greyWithAlphaAndRgbKeepTheirChannelsApart) {
    EXPECT_EQ(nextMipLevel(makeImage(2, 1, 2, {0, 100, 255, 200}), true).pixels,
              (Values{188, 150}));
    EXPECT_EQ(nextMipLevel(makeImage(2, 1, 3, {0, 20, 0, 255, 20, 0}), true).pixels,
              (Values{188, 20, 0}));
}

TEST(MipLevelTest, everySrgbCodeIsTheNearest) {
    std::mt19937 random(7);
    std::uniform_int_distribution<int> byte(0, 255);
    PixelImage image = makeImage(512, 512, 1, Values(512 * 512));
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        // A quarter of them dark, where codes lie closest.
        image.pixels[i] =
            static_cast<std::uint8_t>(i / 512 < 128 ? byte(random) / 16 : byte(random));
    }
    const PixelImage level = nextMipLevel(image, true);
    int wrong = 0;
    for (std::size_t y = 0; y < 256; ++y) {
        for (std::size_t x = 0; x < 256; ++x) {
            double sum = 0.0;
            for (const std::size_t offset : {0, 1, 512, 513}) {
                sum += decoded(image.pixels[2 * y * 512 + 2 * x + offset]);
            }
            // Nothing is further from its code than half a step, and single precision.
            if (std::abs(encoded(0.25 * sum) - level.pixels[y * 256 + x]) > 0.5001) ++wrong;
        }
    }
    EXPECT_EQ(wrong, 0);
}

TEST(MipLevelTest, oneColorStaysItself) {
    for (int code = 0; code < 256; ++code) {
        const Values pixels(6, static_cast<std::uint8_t>(code));
        for (const bool srgb : {false, true}) {
            EXPECT_EQ(nextMipLevel(makeImage(3, 2, 1, pixels), srgb).pixels, Values{pixels[0]});
        }
    }
}

TEST(MipLevelTest, roundingHasNoSide) {
    std::mt19937 random(9);
    std::uniform_int_distribution<int> byte(100, 110);
    PixelImage image = makeImage(256, 256, 1, Values(256 * 256));
    for (std::uint8_t& value : image.pixels) value = static_cast<std::uint8_t>(byte(random));
    const auto meanOf = [](const PixelImage& level) {
        return std::accumulate(level.pixels.begin(), level.pixels.end(), 0.0) /
               static_cast<double>(level.pixels.size());
    };
    const double mean = meanOf(image);
    for (int level = 1; level <= 4; ++level) {
        image = nextMipLevel(image, false);
        // Ties rounded up would add 0.1 a level, as would drivers that round sums of two first.
        EXPECT_NEAR(meanOf(image), mean, 0.06) << "level " << level;
    }
}

TEST(MipLevelTest, keeps16Bits) {
    const PixelImage linear = nextMipLevel(make16(2, 2, {1000, 2000, 65535, 10}), false);
    EXPECT_EQ(linear.bitsPerChannel, 16);
    std::uint16_t value = 0;
    ASSERT_EQ(linear.pixels.size(), 2u);
    std::memcpy(&value, linear.pixels.data(), 2);
    EXPECT_EQ(value, 17136);  // Of 17136.25.
    const PixelImage srgb = nextMipLevel(make16(2, 1, {0, 65535}), true);
    std::memcpy(&value, srgb.pixels.data(), 2);
    EXPECT_NEAR(value, 257.0 * encoded(0.5), 1.0);
}

}  // namespace
}  // namespace polylume
