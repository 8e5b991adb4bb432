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

FloatImage read(const std::filesystem::path& path);
std::vector<std::byte> encodeExr(const FloatImage& image, ExrPrecision precision);
bool drawText(PixelImage& image, std::span<const TextLabel> labels);

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
