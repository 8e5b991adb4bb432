// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image_compare.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace polylume::test {
namespace {

using ::testing::HasSubstr;

FloatImage makeImage() {
    FloatImage image;
    image.width = 3;
    image.height = 2;
    image.channelNames = {"R", "G"};
    image.pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    return image;
}

TEST(ImageCompareTest, equalImagesMatch) {
    EXPECT_EQ(compareImages(makeImage(), makeImage(), {}), "");
}

TEST(ImageCompareTest, lastBitIsSeen) {
    FloatImage image = makeImage();
    image.pixels[7] = std::nextafter(8.0f, 9.0f);
    EXPECT_THAT(compareImages(image, makeImage(), {}), HasSubstr("1 of 6 pixels differ"));
    EXPECT_THAT(compareImages(image, makeImage(), {}), HasSubstr("at (0, 1)"));
    EXPECT_EQ(compareImages(image, makeImage(), {.relative = 1e-6}), "");
}

TEST(ImageCompareTest, outliersAreCounted) {
    FloatImage image = makeImage();
    image.pixels[0] = 100.0f;
    EXPECT_EQ(compareImages(image, makeImage(), {.relative = 1e-3, .outlierShare = 0.2}), "");
    image.pixels[4] = 100.0f;
    EXPECT_NE(compareImages(image, makeImage(), {.relative = 1e-3, .outlierShare = 0.2}), "");
}

TEST(ImageCompareTest, otherSizeIsSeen) {
    FloatImage image = makeImage();
    std::swap(image.width, image.height);
    EXPECT_THAT(compareImages(image, makeImage(), {.relative = 1e9}),
                HasSubstr("expected 3x2 pixels, found 2x3"));
}

TEST(ImageCompareTest, otherChannelsAreSeen) {
    FloatImage image = makeImage();
    image.channelNames[1] = "B";
    EXPECT_THAT(compareImages(image, makeImage(), {.relative = 1e9}), HasSubstr("channels"));
}

TEST(ImageCompareTest, nanNeverMatches) {
    FloatImage image = makeImage();
    image.pixels[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(compareImages(image, makeImage(), {.relative = 1e9}),
                HasSubstr("the image has a value"));
    EXPECT_THAT(compareImages(makeImage(), image, {.relative = 1e9}),
                HasSubstr("the reference has a value"));
    EXPECT_NE(compareImages(image, image, {}), "");
}

}  // namespace
}  // namespace polylume::test
