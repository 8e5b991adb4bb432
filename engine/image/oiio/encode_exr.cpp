// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <OpenImageIO/filesystem.h>

#include <cstring>
#include <memory>

#include "oiio_calls.hpp"
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

}  // namespace polylume::oiio
