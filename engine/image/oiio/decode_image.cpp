// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <OpenImageIO/filesystem.h>

#include <algorithm>
#include <array>
#include <iomanip>
#include <memory>
#include <sstream>

#include "complete_file.hpp"
#include "core/text.hpp"
#include "oiio_calls.hpp"
#include "polylume/error.hpp"

namespace polylume::oiio {
namespace {

constexpr std::array<unsigned char, 8> kPngSignature = {0x89, 'P',  'N',  'G',
                                                        '\r', '\n', 0x1A, '\n'};
constexpr std::array<unsigned char, 3> kJpegSignature = {0xFF, 0xD8, 0xFF};

bool beginsWith(std::span<const std::byte> bytes, std::span<const unsigned char> signature) {
    return bytes.size() >= signature.size() &&
           std::equal(signature.begin(), signature.end(), bytes.begin(),
                      [](unsigned char a, std::byte b) { return std::byte{a} == b; });
}

std::string firstBytes(std::span<const std::byte> bytes) {
    if (bytes.empty()) return "nothing";
    std::ostringstream text;
    text << "bytes" << std::hex << std::setfill('0');
    for (const std::byte byte : bytes.first(std::min<std::size_t>(bytes.size(), 4))) {
        text << ' ' << std::setw(2) << std::to_integer<int>(byte);
    }
    return text.str();
}

/// The format's name for OpenImageIO, by content: glTF files often name the wrong one.
const char* formatOf(std::span<const std::byte> encoded, std::string_view name) {
    const bool isPng = beginsWith(encoded, kPngSignature);
    if (!isPng && !beginsWith(encoded, kJpegSignature)) {
        throw Error(concat("can't decode ", name, ": expected a PNG or JPEG image, found ",
                           firstBytes(encoded)));
    }
    if (!(isPng ? isCompletePng(encoded) : isCompleteJpeg(encoded))) {
        throw Error(concat("can't decode ", name, ": the ", isPng ? "PNG" : "JPEG", " ends after ",
                           encoded.size(), " bytes without its end marker; is it cut off?"));
    }
    return isPng ? "png" : "jpeg";
}

}  // namespace

void checkSize(const OIIO::ImageSpec& spec, std::string_view name) {
    if (spec.deep || spec.depth > 1) {
        throw Error(concat("can't read ", name, ": expected a flat picture, found a ",
                           spec.deep ? "deep image" : "volume"));
    }
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0 ||
        static_cast<std::size_t>(spec.width) >
            kMostPixels / static_cast<std::size_t>(spec.height)) {
        throw Error(concat("can't read ", name, ": expected 1 to ", kMostPixels, " pixels, found ",
                           spec.width, "x", spec.height, " of ", spec.nchannels, " channels"));
    }
}

PixelImage decode(std::span<const std::byte> encoded, std::string_view name) {
    const char* format = formatOf(encoded, name);
    OIIO::Filesystem::IOMemReader memory(encoded.data(), encoded.size());
    const std::unique_ptr<OIIO::ImageInput> file = OIIO::ImageInput::create(format);
    const auto fail = [&] {
        throw Error(concat("can't decode ", name, ": ", takeMessage(file.get())));
    };
    if (file == nullptr || !file->set_ioproxy(&memory)) fail();

    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);  // Colours as stored, not multiplied by alpha.
    OIIO::ImageSpec spec;
    if (!file->open(std::string(name), spec, wanted)) fail();
    checkSize(spec, name);
    if (spec.nchannels > 4) {
        throw Error(
            concat("can't decode ", name, ": expected 1 to 4 channels, found ", spec.nchannels));
    }

    PixelImage image;
    image.width = spec.width;
    image.height = spec.height;
    image.channelCount = spec.nchannels;
    image.bitsPerChannel = spec.format == OIIO::TypeDesc::UINT16 ? 16 : 8;
    const auto type = image.bitsPerChannel == 16 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
    image.pixels.resize(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels *
                        image.bitsPerChannel / 8);
    if (!file->read_image(0, 0, 0, spec.nchannels, type, image.pixels.data())) fail();
    file->close();
    return image;
}

}  // namespace polylume::oiio
