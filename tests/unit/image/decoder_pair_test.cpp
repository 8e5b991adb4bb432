// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Before jpeglib.h, which does not include what it uses.
#include <cstdio>
//
#include <jpeglib.h>
#include <png.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include "core/file.hpp"
#include "image/image_io.hpp"

// decodeImage() beside readImage(), which decodes the same files by OpenImageIO: of every kind that
// libpng and libjpeg write, the same values.
namespace polylume {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Of odd sizes, so that blocks, pairs of chroma and passes of interlacing are cut.
constexpr int kWidth = 37;
constexpr int kHeight = 23;

/// A byte of a picture of waves, from 0 to 255; `channel` counts the bytes of a pixel.
std::uint8_t wave(int x, int y, int channel) {
    const double value = std::sin(0.3 * x + 0.7 * channel) * std::cos(0.2 * y - 0.4 * channel);
    return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * value));
}

struct PngKind {
    int color;
    int bitDepth;
    bool isInterlaced;
    bool hasTransparency;
};

std::vector<std::byte> makePngFile(const PngKind& kind) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    if (setjmp(png_jmpbuf(png)) != 0) std::abort();
    static std::vector<std::byte> file;
    file.clear();
    png_set_write_fn(
        png, &file,
        [](png_structp self, png_bytep bytes, std::size_t count) {
            auto* target = static_cast<std::vector<std::byte>*>(png_get_io_ptr(self));
            const auto* first = reinterpret_cast<const std::byte*>(bytes);
            target->insert(target->end(), first, first + count);
        },
        nullptr);
    png_set_IHDR(png, info, kWidth, kHeight, kind.bitDepth, kind.color,
                 kind.isInterlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (kind.color == PNG_COLOR_TYPE_PALETTE) {
        std::array<png_color, 256> palette{};
        for (int i = 0; i < 256; ++i) palette[i] = {wave(i, 0, 0), wave(i, 9, 1), wave(i, 5, 2)};
        png_set_PLTE(png, info, palette.data(), 1 << kind.bitDepth);
    }
    if (kind.hasTransparency) {
        std::array<png_byte, 16> alpha{};
        for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = static_cast<png_byte>(13 * i);
        png_color_16 clear{};
        clear.gray = 1;
        clear.red = wave(3, 4, 0);
        clear.green = wave(3, 4, 1);
        clear.blue = wave(3, 4, 2);
        const int count =
            kind.color == PNG_COLOR_TYPE_PALETTE ? std::min(16, 1 << kind.bitDepth) : 0;
        png_set_tRNS(png, info, alpha.data(), count, &clear);
    }
    png_write_info(png, info);
    const auto rowBytes = static_cast<int>(png_get_rowbytes(png, info));
    const int passCount = png_set_interlace_handling(png);
    for (int pass = 0; pass < passCount; ++pass) {
        for (int y = 0; y < kHeight; ++y) {
            std::array<png_byte, kWidth * 8> row{};
            for (int i = 0; i < rowBytes; ++i) row[i] = wave(i / 3, y, i % 3);
            png_write_row(png, row.data());
        }
    }
    png_write_end(png, nullptr);
    png_destroy_write_struct(&png, &info);
    return file;
}

struct JpegKind {
    J_COLOR_SPACE color;
    int channelCount;
    int subsampling;
    bool isProgressive;
};

std::vector<std::byte> makeJpegFile(const JpegKind& kind) {
    jpeg_compress_struct encoder{};
    jpeg_error_mgr handler{};
    encoder.err = jpeg_std_error(&handler);
    jpeg_create_compress(&encoder);
    unsigned char* bytes = nullptr;
    unsigned long byteCount = 0;
    jpeg_mem_dest(&encoder, &bytes, &byteCount);
    encoder.image_width = kWidth;
    encoder.image_height = kHeight;
    encoder.input_components = kind.channelCount;
    encoder.in_color_space = kind.color;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 60, TRUE);
    encoder.comp_info[0].h_samp_factor = kind.subsampling;
    encoder.comp_info[0].v_samp_factor = kind.subsampling;
    if (kind.isProgressive) jpeg_simple_progression(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    for (int y = 0; y < kHeight; ++y) {
        std::vector<JSAMPLE> row(static_cast<std::size_t>(kWidth * kind.channelCount));
        for (std::size_t i = 0; i < row.size(); ++i) {
            const int index = static_cast<int>(i);
            row[i] = wave(index / kind.channelCount, y, index % kind.channelCount);
        }
        JSAMPROW first = row.data();
        jpeg_write_scanlines(&encoder, &first, 1);
    }
    jpeg_finish_compress(&encoder);
    jpeg_destroy_compress(&encoder);
    std::vector<std::byte> file(byteCount);
    std::memcpy(file.data(), bytes, byteCount);
    std::free(bytes);
    return file;
}

class DecoderPairTest : public ::testing::Test {
  protected:
    DecoderPairTest() : file_(fs::path(::testing::TempDir()) / "polylume-decoder-pair") {}
    ~DecoderPairTest() override { fs::remove(file_); }

    void expectSame(const std::vector<std::byte>& encoded) const {
        const PixelImage image = decodeImage(encoded, "image");
        writeFile(file_, encoded);
        const FloatImage other = readImage(file_);
        ASSERT_EQ(image.width, kWidth);
        ASSERT_EQ(image.height, kHeight);
        ASSERT_EQ(static_cast<std::size_t>(image.channelCount), other.channelCount());
        const std::size_t bytes = static_cast<std::size_t>(image.bitsPerChannel) / 8;
        ASSERT_EQ(image.pixels.size(), other.pixels.size() * bytes);
        int wrong = 0;
        for (std::size_t i = 0; i < other.pixels.size(); ++i) {
            std::uint16_t value = image.pixels[i * bytes];
            if (bytes == 2) std::memcpy(&value, &image.pixels[2 * i], 2);
            const float scale = bytes == 2 ? 65535.0f : 255.0f;
            if (std::lround(other.pixels[i] * scale) != value) ++wrong;
        }
        EXPECT_EQ(wrong, 0) << "of " << other.pixels.size() << " values";
    }

    const fs::path file_;
};

TEST_F(DecoderPairTest, readsEveryKindOfPng) {
    struct Color {
        int type;
        std::vector<int> bitDepths;
        bool mayHaveTransparency;
    };
    const Color colors[] = {{PNG_COLOR_TYPE_GRAY, {1, 2, 4, 8, 16}, true},
                            {PNG_COLOR_TYPE_PALETTE, {1, 2, 4, 8}, true},
                            {PNG_COLOR_TYPE_RGB, {8, 16}, true},
                            {PNG_COLOR_TYPE_GRAY_ALPHA, {8, 16}, false},
                            {PNG_COLOR_TYPE_RGB_ALPHA, {8, 16}, false}};
    for (const Color& color : colors) {
        for (const int bitDepth : color.bitDepths) {
            for (const bool isInterlaced : {false, true}) {
                for (const bool hasTransparency : {false, true}) {
                    if (hasTransparency && !color.mayHaveTransparency) continue;
                    SCOPED_TRACE("colour type " + std::to_string(color.type) + ", " +
                                 std::to_string(bitDepth) + " bits" +
                                 (isInterlaced ? ", interlaced" : "") +
                                 (hasTransparency ? ", transparent" : ""));
                    expectSame(makePngFile({color.type, bitDepth, isInterlaced, hasTransparency}));
                }
            }
        }
    }
}

TEST_F(DecoderPairTest, readsEveryKindOfJpeg) {
    for (const bool isProgressive : {false, true}) {
        for (const int subsampling : {1, 2}) {
            SCOPED_TRACE((isProgressive ? "progressive, chroma by " : "chroma by ") +
                         std::to_string(subsampling));
            expectSame(makeJpegFile({JCS_RGB, 3, subsampling, isProgressive}));
        }
        expectSame(makeJpegFile({JCS_GRAYSCALE, 1, 1, isProgressive}));
        expectSame(makeJpegFile({JCS_CMYK, 4, 1, isProgressive}));
    }
}

TEST_F(DecoderPairTest, saysWhatIsWrongWithThePixels) {
    std::vector<std::byte> png = makePngFile({PNG_COLOR_TYPE_RGB, 8, false, false});
    png[png.size() - 40] ^= std::byte{0xFF};  // Within the pixels.
    std::string message;
    try {
        decodeImage(png, "bricks.png (images[3])");
    } catch (const std::exception& error) {
        message = error.what();
    }
    EXPECT_THAT(message, HasSubstr("can't decode bricks.png (images[3]): IDAT: "));
}

}  // namespace
}  // namespace polylume
