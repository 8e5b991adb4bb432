// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_image_reader.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/file.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"

namespace polylume::scene {
namespace {

/// The channels of a linear image that are red, green and blue.
std::array<std::size_t, 3> colorChannels(const FloatImage& image, std::string_view place) {
    const auto red = image.channelIndex("R");
    const auto green = image.channelIndex("G");
    const auto blue = image.channelIndex("B");
    if (red && green && blue) return {*red, *green, *blue};
    if (const auto grey = image.channelIndex("Y")) return {*grey, *grey, *grey};
    std::string found;
    for (const std::string& name : image.channelNames) {
        found += concat(found.empty() ? "" : ", ", name);
    }
    throw Error(
        concat("expected the channels R, G and B, or Y alone, found ", found, " (", place, ")"));
}

}  // namespace

bool isExr(std::span<const std::byte> bytes) {
    constexpr std::array<unsigned char, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
    return bytes.size() >= kMagic.size() &&
           std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

LightImage linearImage(const PixelImage& image) {
    const int bytesPerChannel = image.bitsPerChannel / 8;
    const int largest = image.bitsPerChannel == 16 ? 65535 : 255;
    std::vector<float> decoded(static_cast<std::size_t>(largest) + 1);
    for (std::size_t i = 0; i < decoded.size(); ++i) {
        decoded[i] = linearFromSrgb(static_cast<float>(i) / static_cast<float>(largest));
    }
    const std::size_t stride = static_cast<std::size_t>(image.channelCount * bytesPerChannel);
    const bool isGrey = image.channelCount < 3;
    LightImage light;
    light.size = {image.width, image.height};
    light.texels.reserve(image.pixels.size() / stride);
    for (std::size_t i = 0; i + stride <= image.pixels.size(); i += stride) {
        glm::vec3& texel = light.texels.emplace_back();
        for (int c = 0; c < 3; ++c) {
            const std::uint8_t* channel =
                image.pixels.data() + i + (isGrey ? 0 : c) * bytesPerChannel;
            std::uint16_t value = *channel;
            if (bytesPerChannel == 2) std::memcpy(&value, channel, sizeof(value));
            texel[c] = decoded[value];
        }
    }
    return light;
}

LightImage linearImage(const FloatImage& image, std::string_view place,
                       const std::function<void(const std::string&)>& warn) {
    const std::array<std::size_t, 3> channels = colorChannels(image, place);
    LightImage light;
    light.size = {image.width, image.height};
    light.texels.reserve(image.pixels.size() / image.channelCount());
    bool isClean = true;
    for (std::size_t i = 0; i < image.pixels.size(); i += image.channelCount()) {
        glm::vec3& texel = light.texels.emplace_back();
        for (int c = 0; c < 3; ++c) {
            const float value = image.pixels[i + channels[static_cast<std::size_t>(c)]];
            const bool isValid = value >= 0.0f && std::isfinite(value);
            texel[c] = isValid ? value : 0.0f;
            isClean = isClean && isValid;
        }
    }
    if (!isClean) warn("has texels that are negative or not finite; taken as 0");
    return light;
}

LightImage readLightImage(const std::filesystem::path& path) {
    const std::vector<std::byte> bytes = readFile(path);
    const std::string name = path.filename().string();
    if (!isExr(bytes)) return linearImage(decodeImage(bytes, name));
    return linearImage(readImage(path), name, [&](const std::string& problem) {
        log(LogLevel::warning, concat(name, " ", problem));
    });
}

}  // namespace polylume::scene
