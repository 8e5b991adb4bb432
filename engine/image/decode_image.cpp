// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "core/text.hpp"
#include "image/complete_file.hpp"
#include "image/image_io.hpp"
#include "image/jpeg_decoder.hpp"
#include "image/png_codec.hpp"
#include "polylume/error.hpp"

namespace polylume {
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

}  // namespace

PixelImage decodeImage(std::span<const std::byte> encoded, std::string_view name) {
    // By content: glTF files often name the wrong format.
    const bool isPng = beginsWith(encoded, kPngSignature);
    if (!isPng && !beginsWith(encoded, kJpegSignature)) {
        throw Error(concat("can't decode ", name, ": expected a PNG or JPEG image, found ",
                           firstBytes(encoded)));
    }
    if (!(isPng ? isCompletePng(encoded) : isCompleteJpeg(encoded))) {
        throw Error(concat("can't decode ", name, ": the ", isPng ? "PNG" : "JPEG", " ends after ",
                           encoded.size(), " bytes without its end marker; is it cut off?"));
    }
    return isPng ? decodePng(encoded, name) : decodeJpeg(encoded, name);
}

}  // namespace polylume
