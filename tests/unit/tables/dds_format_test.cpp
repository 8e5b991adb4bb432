// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/dds_format.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "support/error_of.hpp"
#include "tables/half_float.hpp"

namespace polylume::tables {
namespace {

using test::errorOf;

using ::testing::AllOf;
using ::testing::HasSubstr;

DdsImage sampleImage(DdsPrecision precision) {
    DdsImage image{5, 3, precision, {}};
    for (int i = 0; i < 60; ++i) image.pixels.push_back(std::sin(static_cast<float>(i)) * 3.0f);
    return image;
}

TEST(DdsFormat, singleFloatsComeBackExactly) {
    const DdsImage image = sampleImage(DdsPrecision::single);
    const std::vector<std::byte> file = encodeDds(image);
    EXPECT_EQ(file.size(), 148u + 60u * 4u);
    const DdsImage read = decodeDds(file, "a.dds");
    EXPECT_EQ(read.width, 5);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.precision, DdsPrecision::single);
    EXPECT_EQ(read.pixels, image.pixels);
}

TEST(DdsFormat, halfFloatsComeBackRounded) {
    const DdsImage image = sampleImage(DdsPrecision::half);
    const std::vector<std::byte> file = encodeDds(image);
    EXPECT_EQ(file.size(), 148u + 60u * 2u);
    const DdsImage read = decodeDds(file, "a.dds");
    EXPECT_EQ(read.precision, DdsPrecision::half);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        EXPECT_EQ(read.pixels[i], floatOf(halfOf(image.pixels[i])));
        EXPECT_NEAR(read.pixels[i], image.pixels[i], std::abs(image.pixels[i]) * 0x1p-11);
    }
}

TEST(DdsFormat, headerFieldsLieWhereTheFormatSays) {
    const std::vector<std::byte> file = encodeDds(sampleImage(DdsPrecision::half));
    const auto word = [&](std::size_t offset) {
        unsigned value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value |= std::to_integer<unsigned>(file[offset + i]) << (8 * i);
        }
        return value;
    };
    EXPECT_EQ(word(0), 0x20534444u);
    EXPECT_EQ(word(4), 124u);
    EXPECT_EQ(word(12), 3u);  // Height before width.
    EXPECT_EQ(word(16), 5u);
    EXPECT_EQ(word(20), 5u * 8u);
    EXPECT_EQ(word(84), 0x30315844u);
    EXPECT_EQ(word(128), 10u);
    EXPECT_EQ(word(132), 3u);
    EXPECT_EQ(word(140), 1u);
}

TEST(DdsFormat, olderCodesAreReadToo) {
    for (const DdsPrecision precision : {DdsPrecision::half, DdsPrecision::single}) {
        std::vector<std::byte> file = encodeDds(sampleImage(precision));
        const std::vector<float> expected = decodeDds(file, "a.dds").pixels;
        file.erase(file.begin() + 128, file.begin() + 148);
        for (std::size_t i = 84; i < 88; ++i) file[i] = std::byte{0};
        file[84] =
            std::byte{static_cast<unsigned char>(precision == DdsPrecision::half ? 113 : 116)};
        const DdsImage read = decodeDds(file, "a.dds");
        EXPECT_EQ(read.precision, precision);
        EXPECT_EQ(read.pixels, expected);
    }
}

TEST(DdsFormat, everyTruncationIsRefused) {
    const std::vector<std::byte> file = encodeDds(sampleImage(DdsPrecision::single));
    for (std::size_t size = 0; size < file.size(); ++size) {
        const std::string error =
            errorOf([&] { decodeDds(std::span(file).first(size), "short.dds"); });
        ASSERT_THAT(error, AllOf(HasSubstr("short.dds: "), HasSubstr("cut short"))) << size;
    }
    std::vector<std::byte> longer = file;
    longer.push_back(std::byte{0});
    EXPECT_THAT(errorOf([&] { decodeDds(longer, "long.dds"); }), HasSubstr("another kind"));
}

TEST(DdsFormat, otherHeadersAreRefusedWithTheirPlace) {
    const std::vector<std::byte> good = encodeDds(sampleImage(DdsPrecision::single));
    const auto errorWith = [&](std::size_t offset, unsigned char value) {
        std::vector<std::byte> file = good;
        file[offset] = std::byte{value};
        return errorOf([&] { decodeDds(file, "bad.dds"); });
    };
    EXPECT_THAT(errorWith(0, 'X'), HasSubstr("\"DDS \""));
    EXPECT_THAT(errorWith(4, 100), AllOf(HasSubstr("byte 4"), HasSubstr("124, found 100")));
    EXPECT_THAT(errorWith(13, 255), AllOf(HasSubstr("the height"), HasSubstr("1 to 1024")));
    EXPECT_THAT(errorWith(16, 0), AllOf(HasSubstr("the width"), HasSubstr("found 0")));
    EXPECT_THAT(errorWith(28, 7), AllOf(HasSubstr("mip maps"), HasSubstr("found 7")));
    EXPECT_THAT(errorWith(76, 0), HasSubstr("pixel format"));
    EXPECT_THAT(errorWith(80, 0x40), HasSubstr("byte 80"));
    EXPECT_THAT(errorWith(84, 'Z'), HasSubstr("113 or 116"));
    EXPECT_THAT(errorWith(113, 0x02), HasSubstr("cube"));
    EXPECT_THAT(errorWith(128, 98), AllOf(HasSubstr("DXGI"), HasSubstr("found 98")));
    EXPECT_THAT(errorWith(132, 4), HasSubstr("the dimension"));
    EXPECT_THAT(errorWith(140, 6), HasSubstr("the array"));
}

TEST(DdsFormat, numbersTooLargeForHalvesAreRefused) {
    DdsImage image = sampleImage(DdsPrecision::half);
    image.pixels[4 * 6] = 70000.0f;
    EXPECT_THAT(errorOf([&] { encodeDds(image); }), HasSubstr("(column 1, row 1)"));
    image.precision = DdsPrecision::single;
    EXPECT_EQ(errorOf([&] { encodeDds(image); }), "no error");
    image.pixels.pop_back();
    EXPECT_THAT(errorOf([&] { encodeDds(image); }), HasSubstr("59 values"));
}

}  // namespace
}  // namespace polylume::tables
