// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/mip_level.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "image/srgb.hpp"

namespace polylume {
namespace {

/// sRGB's 8-bit codes and the light that they stand for.
class SrgbCodes {
  public:
    static const SrgbCodes& get() {
        static const SrgbCodes codes;
        return codes;
    }

    float decode(std::uint8_t code) const { return linear_[code]; }

    /// The nearest code of a value from 0 to 1.
    std::uint8_t encode(float value) const {
        const std::uint8_t code = floor_[static_cast<std::size_t>(value * kBuckets)];
        return static_cast<std::uint8_t>(code + (value >= threshold_[code] ? 1 : 0));
    }

  private:
    // Codes are at least 1 / (12.92 * 255) apart, so no bucket holds two thresholds.
    static constexpr int kBuckets = 4096;

    SrgbCodes() {
        for (std::size_t code = 0; code < 256; ++code) {
            linear_[code] = linearFromSrgb(static_cast<float>(code) / 255.0f);
            // From here on a value is nearer to the next code.
            threshold_[code] =
                code < 255 ? linearFromSrgb((static_cast<float>(code) + 0.5f) / 255.0f) : 2.0f;
        }
        std::uint8_t code = 0;
        for (std::size_t bucket = 0; bucket < floor_.size(); ++bucket) {
            const float value = static_cast<float>(bucket) / kBuckets;
            while (value >= threshold_[code]) ++code;
            floor_[bucket] = code;
        }
    }

    std::array<float, 256> linear_{};
    std::array<float, 256> threshold_{};
    std::array<std::uint8_t, kBuckets + 1> floor_{};  ///< Of the least value of each bucket.
};

/// The nearest integer, the even one of two, so that no level is brighter than the one above for
/// rounding; for values up to 2^22, by the digits that are lost beside 1.5 * 2^23.
float rounded(float value) {
    constexpr float kNoFraction = 12582912.0f;
    return (value + kNoFraction) - kNoFraction;
}

// Like SrgbCodes: what a channel's integers stand for, as decode() says, is averaged and goes back
// by encode().
struct LinearCodec8 {
    float decode(std::uint8_t code) const { return code; }
    std::uint8_t encode(float value) const { return static_cast<std::uint8_t>(rounded(value)); }
};

struct LinearCodec16 {
    float decode(std::uint16_t code) const { return code; }
    std::uint16_t encode(float value) const { return static_cast<std::uint16_t>(rounded(value)); }
};

struct SrgbCodec16 {
    float decode(std::uint16_t code) const { return linearFromSrgb(code / 65535.0f); }
    std::uint16_t encode(float value) const {
        return static_cast<std::uint16_t>(srgbFromLinear(value) * 65535.0f + 0.5f);
    }
};

/// Of the level above along one axis: the two texels around the middle of one of ours.
struct Tap {
    std::size_t first, second;  ///< In values from the axis's start.
    float share;                ///< Of the second.
};

std::vector<Tap> makeTaps(int aboveSize, int size, std::size_t step) {
    std::vector<Tap> taps(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) {
        const float middle = (static_cast<float>(i) + 0.5f) * static_cast<float>(aboveSize) /
                                 static_cast<float>(size) -
                             0.5f;
        const int first = static_cast<int>(middle);
        const int second = std::min(first + 1, aboveSize - 1);
        taps[static_cast<std::size_t>(i)] = {static_cast<std::size_t>(first) * step,
                                             static_cast<std::size_t>(second) * step,
                                             middle - static_cast<float>(first)};
    }
    return taps;
}

/// Fills every `channelCount`-th value of `target` from `first` on.
template <typename T, typename Codec>
void fillChannel(const PixelImage& above, const Codec& codec, int first, PixelImage& target) {
    const auto step = static_cast<std::size_t>(above.channelCount);
    const std::vector<Tap> columns = makeTaps(above.width, target.width, step);
    const std::vector<Tap> rows =
        makeTaps(above.height, target.height, static_cast<std::size_t>(above.width) * step);
    // Vectors of bytes hold 16-bit values at even addresses.
    const T* const source = reinterpret_cast<const T*>(above.pixels.data()) + first;
    T* texel = reinterpret_cast<T*>(target.pixels.data()) + first;
    for (const Tap& row : rows) {
        const T* const upper = source + row.first;
        const T* const lower = source + row.second;
        for (const Tap& column : columns) {
            const auto along = [&](const T* line) {
                return (1.0f - column.share) * codec.decode(line[column.first]) +
                       column.share * codec.decode(line[column.second]);
            };
            *texel = codec.encode((1.0f - row.share) * along(upper) + row.share * along(lower));
            texel += step;
        }
    }
}

}  // namespace

PixelImage nextMipLevel(const PixelImage& above, bool srgb) {
    PixelImage level;
    level.width = std::max(above.width / 2, 1);
    level.height = std::max(above.height / 2, 1);
    level.channelCount = above.channelCount;
    level.bitsPerChannel = above.bitsPerChannel;
    level.pixels.resize(static_cast<std::size_t>(level.width) *
                        static_cast<std::size_t>(level.height) *
                        static_cast<std::size_t>(level.channelCount * level.bitsPerChannel / 8));
    const int alpha = above.channelCount % 2 == 0 ? above.channelCount - 1 : -1;
    for (int channel = 0; channel < above.channelCount; ++channel) {
        const bool isSrgb = srgb && channel != alpha;
        if (above.bitsPerChannel == 16 && isSrgb) {
            fillChannel<std::uint16_t>(above, SrgbCodec16(), channel, level);
        } else if (above.bitsPerChannel == 16) {
            fillChannel<std::uint16_t>(above, LinearCodec16(), channel, level);
        } else if (isSrgb) {
            fillChannel<std::uint8_t>(above, SrgbCodes::get(), channel, level);
        } else {
            fillChannel<std::uint8_t>(above, LinearCodec8(), channel, level);
        }
    }
    return level;
}

}  // namespace polylume
