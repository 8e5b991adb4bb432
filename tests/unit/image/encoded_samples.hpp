// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Small PNG and JPEG files made here byte by byte, so that the decoder under test is not checked by
// its own encoder.
namespace polylume::test {

using Bytes = std::vector<std::byte>;

/// PNG colour types (PNG specification, third edition, table 9).
enum class PngColor : std::uint8_t { grey = 0, rgb = 2, palette = 3, greyAlpha = 4, rgba = 6 };

struct PngSample {
    int width = 1;
    int height = 1;
    int bitDepth = 8;
    PngColor color = PngColor::rgb;
    /// As in the file: each row from its first bit, 16-bit values with the high byte first. Rows
    /// that are not here are missing in the file.
    std::vector<std::uint8_t> rows{};
    /// Chunks between the header and the pixels: type and data.
    std::vector<std::pair<std::string, std::vector<std::uint8_t>>> chunks{};
};

Bytes makePng(const PngSample& sample);

/// The chunks of a PNG file, type and data. Throws std::runtime_error for a chunk with a wrong
/// checksum or a length beyond the end.
std::vector<std::pair<std::string, std::string>> pngChunks(const Bytes& file);

/// A baseline JPEG of 8x8 pixels that all have these components: 1 grey, 3 Y Cb Cr, 4 CMYK. The
/// quantiser is 1, so that grey decodes to the exact value.
Bytes makeJpeg(const std::vector<int>& components);

}  // namespace polylume::test
