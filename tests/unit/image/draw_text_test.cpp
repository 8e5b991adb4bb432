// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>

#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

PixelImage whiteImage() {
    PixelImage image;
    image.width = 120;
    image.height = 40;
    image.channelCount = 3;
    image.pixels.assign(120 * 40 * 3, 255);
    return image;
}

/// The columns that hold ink: the first and the last.
std::pair<int, int> inkedColumns(const PixelImage& image) {
    std::pair<int, int> columns{image.width, -1};
    for (int i = 0; i < image.width * image.height; ++i) {
        if (image.pixels[static_cast<std::size_t>(i) * 3] > 128) continue;
        columns.first = std::min(columns.first, i % image.width);
        columns.second = std::max(columns.second, i % image.width);
    }
    return columns;
}

TEST(DrawText, standsWhereItsAlignmentSays) {
    for (const TextAlign align : {TextAlign::left, TextAlign::middle, TextAlign::right}) {
        PixelImage image = whiteImage();
        const TextLabel label{"HHHH", 60, 20, 16, align, {0, 0, 0}};
        if (!drawText(image, {&label, 1})) GTEST_SKIP() << "no font here";
        const auto [first, last] = inkedColumns(image);
        ASSERT_LE(first, last);
        const double middle = 0.5 * (first + last);
        if (align == TextAlign::left) {
            EXPECT_GE(first, 59);
            EXPECT_LE(first, 64);
        } else if (align == TextAlign::middle) {
            EXPECT_NEAR(middle, 60.0, 3.0);
        } else {
            EXPECT_LE(last, 61);
            EXPECT_GE(last, 56);
        }
    }
}

TEST(DrawText, leavesAPictureWithoutLabelsAlone) {
    PixelImage image = whiteImage();
    drawText(image, {});
    EXPECT_EQ(image.pixels, whiteImage().pixels);
}

TEST(DrawText, refusesOtherPictures) {
    PixelImage image = whiteImage();
    image.pixels.pop_back();
    EXPECT_THROW(drawText(image, {}), Error);
}

}  // namespace
}  // namespace polylume
