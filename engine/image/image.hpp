// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polylume {

/// Named values stored with an image: EXR attributes, PNG text.
using ImageMetadata = std::map<std::string, std::variant<int, float, std::string>>;

/// What the colours of a picture mean.
enum class PixelValues {
    linear,   ///< Radiance in proportion, as files of half and float values hold (ours in nits).
    display,  ///< sRGB-encoded, 0 to 1, as files of integers hold.
};

/// A picture of float channels, row by row from the top, channels interleaved.
struct FloatImage {
    int width = 0;
    int height = 0;
    std::vector<std::string>
        channelNames;           ///< One per channel, in the order of storage: "R", "normal.X"
    std::vector<float> pixels;  ///< width * height * channelNames.size()
    PixelValues values = PixelValues::linear;
    bool hasMoreParts = false;  ///< The file it was read from holds further parts, pages or frames.
    ImageMetadata metadata;

    std::size_t channelCount() const { return channelNames.size(); }
    /// Where the channel of this name is in a pixel, from 0; empty when there is none.
    std::optional<std::size_t> channelIndex(std::string_view name) const {
        const auto found = std::find(channelNames.begin(), channelNames.end(), name);
        if (found == channelNames.end()) return std::nullopt;
        return static_cast<std::size_t>(found - channelNames.begin());
    }
    /// The first value of the pixel in column `x` from the left, row `y` from the top.
    float* pixel(int x, int y) { return pixels.data() + pixelOffset(x, y); }
    const float* pixel(int x, int y) const { return pixels.data() + pixelOffset(x, y); }

  private:
    std::size_t pixelOffset(int x, int y) const {
        return (static_cast<std::size_t>(y) * width + x) * channelNames.size();
    }
};

/// A decoded PNG or JPEG as it was stored: integers, no colour conversion, rows from the top,
/// channels interleaved: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
struct PixelImage {
    int width = 0;
    int height = 0;
    int channelCount = 0;
    int bitsPerChannel = 8;            ///< 8, or 16 in the byte order of this machine
    std::vector<std::uint8_t> pixels;  ///< width * height * channelCount * bitsPerChannel / 8
};

enum class TextAlign { left, middle, right };

/// One line of text to be drawn into a picture.
struct TextLabel {
    std::string text;  ///< ASCII; OpenImageIO 2.4 draws other characters wrong.
    int x = 0;         ///< Pixels from the left to where `align` says: its left end, and so on.
    int y = 0;         ///< Pixels from the top to the middle of the line's capital letters.
    int size = 16;     ///< Height of the line, in pixels.
    TextAlign align = TextAlign::left;
    std::array<std::uint8_t, 3> color{};
};

}  // namespace polylume
