// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/dds_format.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/text.hpp"
#include "polylume/error.hpp"
#include "tables/half_float.hpp"

// All little-endian: "DDS ", DDS_HEADER of 124 bytes, with the code "DX10" also DDS_HEADER_DXT10 of
// 20 bytes, then the pixels.
namespace polylume::tables {
namespace {

constexpr std::size_t kHeaderEnd = 128;
constexpr std::size_t kExtendedHeaderEnd = 148;

// Where the fields lie in the file, and what they hold for our textures.
constexpr std::size_t kMagicAt = 0;
constexpr std::uint32_t kMagic = 0x20534444;  // "DDS "
constexpr std::size_t kHeaderSizeAt = 4;
constexpr std::uint32_t kHeaderSize = 124;
constexpr std::size_t kFlagsAt = 8;
constexpr std::uint32_t kFlags = 0x100f;  // Caps, height, width, pitch, pixel format.
constexpr std::size_t kHeightAt = 12;
constexpr std::size_t kWidthAt = 16;
constexpr std::size_t kPitchAt = 20;
constexpr std::size_t kDepthAt = 24;
constexpr std::size_t kMipCountAt = 28;
constexpr std::size_t kPixelFormatSizeAt = 76;
constexpr std::uint32_t kPixelFormatSize = 32;
constexpr std::size_t kPixelFormatFlagsAt = 80;
constexpr std::uint32_t kHasFourCode = 0x4;
constexpr std::size_t kFourCodeAt = 84;
constexpr std::uint32_t kDx10 = 0x30315844;  // "DX10"
constexpr std::uint32_t kOldHalf = 113;      // D3DFMT_A16B16G16R16F
constexpr std::uint32_t kOldSingle = 116;    // D3DFMT_A32B32G32R32F
constexpr std::size_t kCapsAt = 108;
constexpr std::uint32_t kIsTexture = 0x1000;
constexpr std::size_t kCaps2At = 112;
constexpr std::uint32_t kIsCubeOrVolume = 0x20fe00;
constexpr std::size_t kDxgiFormatAt = 128;
constexpr std::uint32_t kDxgiSingle = 2;
constexpr std::uint32_t kDxgiHalf = 10;
constexpr std::size_t kDimensionAt = 132;
constexpr std::uint32_t kTexture2d = 3;
constexpr std::size_t kMiscAt = 136;
constexpr std::size_t kArraySizeAt = 140;

std::size_t bytesOf(DdsPrecision precision) {
    return precision == DdsPrecision::half ? 2 : 4;
}

void putU32(std::vector<std::byte>& file, std::size_t offset, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        file[offset + i] = static_cast<std::byte>(value >> (8 * i) & 0xff);
    }
}

std::uint32_t getUnsigned(std::span<const std::byte> file, std::size_t offset, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        value |= std::to_integer<std::uint32_t>(file[offset + i]) << (8 * i);
    }
    return value;
}

/// Reads a header, and says of a field what was wrong with it.
class HeaderReader {
  public:
    explicit HeaderReader(std::span<const std::byte> file) : file_(file) {}

    std::uint32_t read(std::size_t offset) const { return getUnsigned(file_, offset, 4); }

    void expect(std::size_t offset, std::uint32_t expected, std::string_view field) const {
        if (read(offset) != expected) fail(offset, field, concat(expected));
    }

    [[noreturn]] void fail(std::size_t offset, std::string_view field,
                           std::string_view expected) const {
        throw Error(concat("expected ", field, " (byte ", offset, ") to be ", expected, ", found ",
                           read(offset),
                           ": only flat RGBA textures of half or single floats are read"));
    }

  private:
    std::span<const std::byte> file_;
};

void checkLength(std::span<const std::byte> file, std::size_t expected, std::string_view what) {
    if (file.size() >= expected) return;
    throw Error(concat("expected ", expected, " bytes for ", what, ", found ", file.size(),
                       ": the file is cut short, fetch or export it anew"));
}

/// What a header says; `dataOffset` is where the pixels begin.
struct Header {
    int width = 0;
    int height = 0;
    DdsPrecision precision = DdsPrecision::single;
    std::size_t dataOffset = kHeaderEnd;
};

DdsPrecision readExtended(const HeaderReader& header) {
    header.expect(kDimensionAt, kTexture2d, "the dimension");
    header.expect(kArraySizeAt, 1, "the size of the array");
    const std::uint32_t format = header.read(kDxgiFormatAt);
    if (format != kDxgiHalf && format != kDxgiSingle) {
        header.fail(kDxgiFormatAt, "the DXGI format",
                    "2 (R32G32B32A32_FLOAT) or 10 (R16G16B16A16_FLOAT)");
    }
    return format == kDxgiHalf ? DdsPrecision::half : DdsPrecision::single;
}

int readSide(const HeaderReader& header, std::size_t offset, std::string_view field) {
    const std::uint32_t side = header.read(offset);
    if (side < 1 || side > DdsImage::kMaxSize) {
        header.fail(offset, field, concat("1 to ", DdsImage::kMaxSize));
    }
    return static_cast<int>(side);
}

Header readHeader(std::span<const std::byte> file) {
    checkLength(file, kHeaderEnd, "a DDS header");
    const HeaderReader header(file);
    if (header.read(kMagicAt) != kMagic) header.fail(kMagicAt, "the first word", "\"DDS \"");
    header.expect(kHeaderSizeAt, kHeaderSize, "the size of the header");
    header.expect(kPixelFormatSizeAt, kPixelFormatSize, "the size of the pixel format");
    if ((header.read(kPixelFormatFlagsAt) & kHasFourCode) == 0) {
        header.fail(kPixelFormatFlagsAt, "the flags of the pixel format", "with a code, 4");
    }
    if (header.read(kMipCountAt) > 1) header.fail(kMipCountAt, "the count of mip maps", "1");
    if ((header.read(kCaps2At) & kIsCubeOrVolume) != 0) {
        header.fail(kCaps2At, "the second capabilities", "of no cube or volume, 0");
    }
    Header result;
    result.width = readSide(header, kWidthAt, "the width");
    result.height = readSide(header, kHeightAt, "the height");
    const std::uint32_t code = header.read(kFourCodeAt);
    if (code == kDx10) {
        checkLength(file, kExtendedHeaderEnd, "a DDS header of the code DX10");
        result.precision = readExtended(header);
        result.dataOffset = kExtendedHeaderEnd;
    } else if (code == kOldHalf || code == kOldSingle) {
        result.precision = code == kOldHalf ? DdsPrecision::half : DdsPrecision::single;
    } else {
        header.fail(kFourCodeAt, "the code of the pixel format", "\"DX10\", 113 or 116");
    }
    return result;
}

DdsImage decode(std::span<const std::byte> file) {
    const Header header = readHeader(file);
    DdsImage image{header.width, header.height, header.precision, {}};
    const std::size_t bytes = bytesOf(image.precision);
    const std::size_t count = static_cast<std::size_t>(image.width) * image.height * 4;
    const std::size_t expected = header.dataOffset + count * bytes;
    checkLength(file, expected, concat(image.width, "x", image.height, " pixels"));
    if (file.size() > expected) {
        throw Error(concat("expected ", expected, " bytes for ", image.width, "x", image.height,
                           " pixels, found ", file.size(), ": this is another kind of texture"));
    }
    image.pixels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t bits = getUnsigned(file, header.dataOffset + i * bytes, bytes);
        image.pixels[i] = image.precision == DdsPrecision::half
                              ? floatOf(static_cast<std::uint16_t>(bits))
                              : std::bit_cast<float>(bits);
    }
    return image;
}

void checkImage(const DdsImage& image) {
    const auto fits = [](int side) { return side >= 1 && side <= DdsImage::kMaxSize; };
    if (!fits(image.width) || !fits(image.height) ||
        image.pixels.size() != static_cast<std::size_t>(image.width) * image.height * 4) {
        throw Error(concat("expected a texture of 1 to ", DdsImage::kMaxSize,
                           " pixels a side with four values each, found ", image.width, "x",
                           image.height, " and ", image.pixels.size(), " values"));
    }
    if (image.precision == DdsPrecision::single) return;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (std::isfinite(floatOf(halfOf(image.pixels[i])))) continue;
        const std::size_t pixel = i / 4;
        throw Error(concat("expected a number that half floats can hold, found ", image.pixels[i],
                           " (column ", pixel % image.width, ", row ", pixel / image.width,
                           "): export single floats"));
    }
}

}  // namespace

std::vector<std::byte> encodeDds(const DdsImage& image) {
    checkImage(image);
    const std::size_t bytes = bytesOf(image.precision);
    const bool isHalf = image.precision == DdsPrecision::half;
    std::vector<std::byte> file(kExtendedHeaderEnd + image.pixels.size() * bytes);
    putU32(file, kMagicAt, kMagic);
    putU32(file, kHeaderSizeAt, kHeaderSize);
    putU32(file, kFlagsAt, kFlags);
    putU32(file, kHeightAt, static_cast<std::uint32_t>(image.height));
    putU32(file, kWidthAt, static_cast<std::uint32_t>(image.width));
    putU32(file, kPitchAt, static_cast<std::uint32_t>(image.width * 4 * bytes));
    putU32(file, kDepthAt, 1);
    putU32(file, kMipCountAt, 1);
    putU32(file, kPixelFormatSizeAt, kPixelFormatSize);
    putU32(file, kPixelFormatFlagsAt, kHasFourCode);
    putU32(file, kFourCodeAt, kDx10);
    putU32(file, kCapsAt, kIsTexture);
    putU32(file, kDxgiFormatAt, isHalf ? kDxgiHalf : kDxgiSingle);
    putU32(file, kDimensionAt, kTexture2d);
    putU32(file, kMiscAt, 0);
    putU32(file, kArraySizeAt, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const std::size_t offset = kExtendedHeaderEnd + i * bytes;
        if (!isHalf) {
            putU32(file, offset, std::bit_cast<std::uint32_t>(image.pixels[i]));
            continue;
        }
        const std::uint16_t half = halfOf(image.pixels[i]);
        file[offset] = static_cast<std::byte>(half & 0xff);
        file[offset + 1] = static_cast<std::byte>(half >> 8);
    }
    return file;
}

DdsImage decodeDds(std::span<const std::byte> file, std::string_view name) {
    try {
        return decode(file);
    } catch (const Error& error) {
        throw Error(concat(name, ": ", error.what()));
    }
}

}  // namespace polylume::tables
