// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <OpenImageIO/filesystem.h>

#include <charconv>
#include <cstring>
#include <memory>

#include "oiio_calls.hpp"
#include "png_text.hpp"
#include "polylume/error.hpp"

namespace polylume::oiio {
namespace {

/// Writes `pixels` of `type` as one file of `format`, which begins as `spec` says.
std::vector<unsigned char> encode(const char* format, const OIIO::ImageSpec& spec,
                                  const OIIO::TypeDesc& type, const void* pixels) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const std::unique_ptr<OIIO::ImageOutput> file = OIIO::ImageOutput::create(format);
    // The name is never opened; OpenImageIO only wants one.
    if (file == nullptr || !file->set_ioproxy(&memory) || !file->open("memory", spec) ||
        !file->write_image(type, pixels) || !file->close()) {
        throw Error(takeMessage(file.get()));
    }
    return bytes;
}

std::vector<std::byte> asBytes(const std::vector<unsigned char>& bytes) {
    std::vector<std::byte> copy(bytes.size());
    if (!bytes.empty()) std::memcpy(copy.data(), bytes.data(), bytes.size());
    return copy;
}

struct TextOf {
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(int value) const { return std::to_string(value); }
    std::string operator()(float value) const {
        // The shortest text that reads back as the same float.
        char text[32];
        return {text, std::to_chars(text, text + sizeof(text), value).ptr};
    }
};

}  // namespace

std::vector<std::byte> encodeExr(const FloatImage& image, ExrPrecision precision) {
    const auto type =
        precision == ExrPrecision::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
    OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channelNames.size()),
                         type);
    spec.channelnames = image.channelNames;
    spec.attribute("compression", "zip");
    // Where there is none, OpenImageIO puts in the time of day, and no two runs would write the
    // same.
    spec.attribute("DateTime", "");
    for (const auto& [name, value] : image.metadata) {
        std::visit([&, key = name](const auto& typed) { spec.attribute(key, typed); }, value);
    }
    return asBytes(encode("openexr", spec, OIIO::TypeDesc::FLOAT, image.pixels.data()));
}

std::vector<std::byte> encodePng(const PixelImage& image, const ImageMetadata& metadata) {
    OIIO::ImageSpec spec(image.width, image.height, image.channelCount, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);  // Colours as given, not divided by alpha.
    spec.attribute("oiio:ColorSpace", "sRGB");
    // A quarter of the time of OpenImageIO's default (21 ms for 1280x720) for 7 % more bytes.
    constexpr int kUpFilter = 0x20;  // libpng's PNG_FILTER_UP.
    spec.attribute("png:filter", kUpFilter);
    spec.attribute("png:compressionLevel", 4);
    std::vector<PngText> texts;
    for (const auto& [name, value] : metadata) {
        texts.push_back({name, std::visit(TextOf{}, value)});
    }
    const auto file = encode("png", spec, OIIO::TypeDesc::UINT8, image.pixels.data());
    return insertPngTexts(asBytes(file), texts);
}

}  // namespace polylume::oiio
