// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/light_texture_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "core/text.hpp"
#include "image/image_io.hpp"
#include "image/srgb.hpp"
#include "polylume/error.hpp"
#include "scene/gltf_value.hpp"
#include "scene/sampler_reader.hpp"
#include "scene/uri.hpp"

namespace polylume::scene {
namespace {

bool isExr(std::span<const std::byte> bytes) {
    constexpr std::array<unsigned char, 4> kMagic{0x76, 0x2f, 0x31, 0x01};
    return bytes.size() >= kMagic.size() &&
           std::memcmp(bytes.data(), kMagic.data(), kMagic.size()) == 0;
}

/// The channels of a linear image that are red, green and blue.
std::array<std::size_t, 3> colorChannels(const FloatImage& image, const std::string& place) {
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

LightImage linearImage(const FloatImage& image, const GltfDocument& document,
                       const std::string& where) {
    const std::array<std::size_t, 3> channels = colorChannels(image, document.place(where));
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
    if (!isClean) {
        document.warn(concat(where, " has texels that are negative or not finite; taken as 0"));
    }
    return light;
}

}  // namespace

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

TextureWrap lightWrap(Wrap wrap) {
    switch (wrap) {
        case Wrap::repeat:
            return TextureWrap::repeat;
        case Wrap::mirroredRepeat:
            return TextureWrap::mirroredRepeat;
        case Wrap::clampToEdge:
            break;
    }
    return TextureWrap::clampToEdge;
}

LightTexture LightTextureReader::read(const tinygltf::Value& texture, const std::string& where) {
    const bool hasIndex = texture.Has("index");
    if (hasIndex == texture.Has("uri")) {
        throw Error(concat("expected either \"index\" or \"uri\", found ",
                           hasIndex ? "both" : "neither", " (", document_.place(where),
                           ", texture)"));
    }
    if (hasIndex) return readIndexed(integerOr(texture, "index", 0), where);
    const std::string uri = textOr(texture, "uri", "");
    std::shared_ptr<const LightImage>& image = images_[uri];
    if (!image) image = std::make_shared<LightImage>(readFile(uri, where));
    LightTexture read;
    read.image = image;
    return read;
}

LightTexture LightTextureReader::readIndexed(int gltfTexture, const std::string& where) {
    const tinygltf::Texture& source = document_.model().textures[gltfTexture];
    if (source.source < 0) {
        throw Error(concat("expected textures[", gltfTexture,
                           "] to have a \"source\", found none (", document_.place(where),
                           ", texture)"));
    }
    const std::string key = concat("images[", source.source, "]");
    std::shared_ptr<const LightImage>& image = images_[key];
    if (!image) {
        image = std::make_shared<LightImage>(
            linearImage(decodeImage(document_.imageBytes(source.source), document_.place(key))));
    }
    const Sampler sampler = readSampler(document_.model(), source.sampler);
    LightTexture read;
    read.image = image;
    read.wrapU = lightWrap(sampler.wrapU);
    read.wrapV = lightWrap(sampler.wrapV);
    return read;
}

LightImage LightTextureReader::readFile(const std::string& uri, const std::string& where) const {
    const std::string here = where + ", texture";
    const std::string place = document_.place(here);
    const std::vector<std::byte> bytes = readUri(uri, document_.folder(), place);
    if (!isExr(bytes)) return linearImage(decodeImage(bytes, place));
    if (uri.starts_with("data:")) {
        throw Error(concat("expected a PNG or JPEG in the data URI, found an OpenEXR (", place,
                           "); put it in a file beside the scene"));
    }
    return linearImage(readImage(fileOfUri(uri, document_.folder(), place)), document_, here);
}

}  // namespace polylume::scene
