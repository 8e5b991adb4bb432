// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image_library.hpp"

// The functions behind ImageLibrary. They throw Error; image_library.cpp turns that into messages.
namespace polylume::oiio {

/// More than any texture or picture of ours, and far less than what a forged header can ask for.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 28;

PixelImage decode(std::span<const std::byte> encoded, std::string_view name);
FloatImage read(const std::filesystem::path& path);
std::vector<std::byte> encodeExr(const FloatImage& image, ExrPrecision precision);
std::vector<std::byte> encodePng(const PixelImage& image, const ImageMetadata& metadata);
bool drawText(PixelImage& image, std::span<const TextLabel> labels);

/// Throws Error that names `name` when the image has no pixels, too many, or is not a flat picture.
void checkSize(const OIIO::ImageSpec& spec, std::string_view name);

/// The message of the last failure on `file`, as one line. Also empties OpenImageIO's own store of
/// messages of this thread, so that a later failure doesn't tell of this one.
template <typename File>
std::string takeMessage(const File* file) {
    std::string message = file != nullptr ? file->geterror() : std::string();
    const std::string global = OIIO::geterror();
    if (message.empty()) message = global.empty() ? "OpenImageIO gives no reason" : global;
    while (!message.empty() && message.back() == '\n') message.pop_back();
    for (char& character : message) {
        if (character == '\n') character = ' ';
    }
    return message;
}

}  // namespace polylume::oiio
