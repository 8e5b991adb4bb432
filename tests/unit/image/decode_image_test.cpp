// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>
#include <thread>

#include "encoded_samples.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

using test::Bytes;
using test::makeJpeg;
using test::makePng;
using test::PngColor;
using test::PngSample;
using ::testing::AllOf;
using ::testing::HasSubstr;

using Values = std::vector<std::uint8_t>;

std::string failureOf(const Bytes& encoded) {
    try {
        decodeImage(encoded, "bricks.png (images[3])");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::vector<std::uint16_t> as16Bits(const PixelImage& image) {
    std::vector<std::uint16_t> values(image.pixels.size() / 2);
    std::memcpy(values.data(), image.pixels.data(), image.pixels.size());
    return values;
}

TEST(DecodePngTest, keepsEachColorTypeAsStored) {
    struct Case {
        PngColor color;
        int channelCount;
        Values rows;  // 2x2.
    };
    const Case cases[] = {
        {PngColor::grey, 1, {0, 1, 254, 255}},
        {PngColor::greyAlpha, 2, {10, 0, 20, 1, 30, 128, 40, 255}},
        {PngColor::rgb, 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
        // Colours under alpha 0 and above alpha: lost by multiplying, clipped by dividing.
        {PngColor::rgba, 4, {255, 99, 7, 0, 250, 251, 252, 1, 9, 9, 9, 128, 0, 128, 255, 255}},
    };
    for (const Case& expected : cases) {
        const PixelImage image = decodeImage(
            makePng({.width = 2, .height = 2, .color = expected.color, .rows = expected.rows}), "");
        EXPECT_EQ(image.width, 2);
        EXPECT_EQ(image.height, 2);
        EXPECT_EQ(image.channelCount, expected.channelCount);
        EXPECT_EQ(image.bitsPerChannel, 8);
        EXPECT_EQ(image.pixels, expected.rows) << expected.channelCount << " channels";
    }
}

TEST(DecodePngTest, keeps16BitsInTheMachinesOrder) {
    const PixelImage image =
        decodeImage(makePng({.bitDepth = 16,
                             .color = PngColor::rgba,
                             .rows = {0x12, 0x34, 0xFF, 0xFE, 0x00, 0x01, 0x80, 0x00}}),
                    "");
    EXPECT_EQ(image.bitsPerChannel, 16);
    EXPECT_EQ(as16Bits(image), (std::vector<std::uint16_t>{0x1234, 0xFFFE, 0x0001, 0x8000}));
}

TEST(DecodePngTest, spreadsFewerBitsTo8) {
    const PixelImage image = decodeImage(
        makePng({.width = 4, .bitDepth = 2, .color = PngColor::grey, .rows = {0b00011011}}), "");
    EXPECT_EQ(image.pixels, (Values{0, 85, 170, 255}));
}

TEST(DecodePngTest, looksUpPalettes) {
    const Values colors = {255, 0, 0, 0, 200, 0, 1, 2, 3};
    const PixelImage opaque = decodeImage(makePng({.width = 3,
                                                   .color = PngColor::palette,
                                                   .rows = {2, 0, 1},
                                                   .chunks = {{"PLTE", colors}}}),
                                          "");
    EXPECT_EQ(opaque.channelCount, 3);
    EXPECT_EQ(opaque.pixels, (Values{1, 2, 3, 255, 0, 0, 0, 200, 0}));
    const PixelImage clear = decodeImage(makePng({.width = 3,
                                                  .color = PngColor::palette,
                                                  .rows = {2, 0, 1},
                                                  .chunks = {{"PLTE", colors}, {"tRNS", {7, 0}}}}),
                                         "");
    EXPECT_EQ(clear.channelCount, 4);
    EXPECT_EQ(clear.pixels, (Values{1, 2, 3, 255, 255, 0, 0, 7, 0, 200, 0, 0}));
}

TEST(DecodePngTest, ignoresGamma) {
    // gAMA 1.0: a viewer would convert, a texture's slot says itself what it holds.
    const PixelImage image = decodeImage(
        makePng({.rows = {10, 100, 200}, .chunks = {{"gAMA", {0x00, 0x01, 0x86, 0xA0}}}}), "");
    EXPECT_EQ(image.pixels, (Values{10, 100, 200}));
}

TEST(DecodeJpegTest, decodesGreyExactly) {
    for (const int value : {0, 1, 100, 128, 160, 255}) {
        const PixelImage image = decodeImage(makeJpeg({value}), "");
        EXPECT_EQ(image.width, 8);
        EXPECT_EQ(image.height, 8);
        EXPECT_EQ(image.channelCount, 1);
        EXPECT_EQ(image.bitsPerChannel, 8);
        EXPECT_EQ(image.pixels, Values(64, static_cast<std::uint8_t>(value)));
    }
}

TEST(DecodeJpegTest, convertsYCbCrToRgb) {
    const PixelImage image = decodeImage(makeJpeg({90, 91, 206}), "");
    ASSERT_EQ(image.channelCount, 3);
    ASSERT_EQ(image.pixels.size(), 192u);
    // JFIF 1.02: R = Y + 1.402 (Cr - 128) and so on; a decoder in integers may be off by one.
    EXPECT_NEAR(image.pixels[0], 90 + 1.402 * 78, 1.0);
    EXPECT_NEAR(image.pixels[1], 90 + 0.344136 * 37 - 0.714136 * 78, 1.0);
    EXPECT_NEAR(image.pixels[2], 90 - 1.772 * 37, 1.0);
}

TEST(DecodeJpegTest, convertsCmykToRgb) {
    // As Adobe stores it, inverted: 255 is no ink.
    const PixelImage image = decodeImage(makeJpeg({255, 128, 0, 255}), "");
    ASSERT_EQ(image.channelCount, 3);
    EXPECT_NEAR(image.pixels[0], 255, 1);
    EXPECT_NEAR(image.pixels[1], 128, 1);
    EXPECT_NEAR(image.pixels[2], 0, 1);
}

TEST(DecodeImageTest, saysWhatIsNoImage) {
    EXPECT_THAT(failureOf({}), AllOf(HasSubstr("bricks.png (images[3])"), HasSubstr("PNG or JPEG"),
                                     HasSubstr("nothing")));
    EXPECT_THAT(failureOf({std::byte{'G'}, std::byte{'I'}, std::byte{'F'}}),
                HasSubstr("bytes 47 49 46"));
}

TEST(DecodeImageTest, refusesEveryTruncatedFile) {
    PngSample sample = {.width = 8, .height = 8};
    for (int value = 0; value < 8 * 8 * 3; ++value) {
        sample.rows.push_back(static_cast<std::uint8_t>(value));
    }
    const Bytes png = makePng(sample);
    const Bytes jpeg = makeJpeg({90, 91, 206});
    EXPECT_EQ(failureOf(png), "");
    EXPECT_EQ(failureOf(jpeg), "");
    for (const Bytes& whole : {png, jpeg}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
            EXPECT_THAT(failureOf(part), HasSubstr("bricks.png"))
                << size << " of " << whole.size() << " bytes";
        }
    }
}

TEST(DecodeImageTest, survivesEveryBrokenByte) {
    const Bytes files[] = {makePng({.width = 2, .height = 1, .rows = {1, 2, 3, 4, 5, 6}}),
                           makeJpeg({90, 91, 206})};
    for (const Bytes& whole : files) {
        for (std::size_t index = 0; index < whole.size(); ++index) {
            Bytes broken = whole;
            broken[index] ^= std::byte{0x55};
            // Some bytes carry nothing, so both an image and an error will do.
            failureOf(broken);
        }
    }
}

TEST(DecodeImageTest, refusesASizeThatWouldFillTheMemory) {
    EXPECT_THAT(failureOf(makePng({.width = 100000, .height = 100000})),
                AllOf(HasSubstr("bricks.png"), HasSubstr("100000")));
}

TEST(DecodeImageTest, worksInSeveralThreadsAtOnce) {
    const Bytes png = makePng({.rows = {1, 2, 3}});
    const Bytes jpeg = makeJpeg({77});
    std::array<int, 4> wrong{};
    std::vector<std::thread> threads;
    threads.reserve(wrong.size());
    for (int& count : wrong) {
        threads.emplace_back([&] {
            for (int round = 0; round < 50; ++round) {
                if (decodeImage(png, "png").pixels != Values{1, 2, 3}) ++count;
                if (decodeImage(jpeg, "jpeg").pixels != Values(64, 77)) ++count;
                if (failureOf({}).empty()) ++count;
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, (std::array<int, 4>{}));
}

}  // namespace
}  // namespace polylume
