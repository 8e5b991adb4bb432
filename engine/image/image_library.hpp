// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"
#include "image/image_io.hpp"

namespace polylume {

/// What the shared object around OpenImageIO offers. Each function returns an empty string when it
/// has done its work, and otherwise the message of the Error to throw: no exception crosses the
/// border of the shared object, where the two sides could disagree on its type.
struct ImageLibrary {
    std::string (*read)(const std::filesystem::path& path, FloatImage& image);
    std::string (*encodeExr)(const FloatImage& image, ExrPrecision precision,
                             std::vector<std::byte>& file);
    std::string (*drawText)(PixelImage& image, std::span<const TextLabel> labels, bool& hasFont);
};

/// Goes up with every change of ImageLibrary or of a type that it names.
inline constexpr int kImageLibraryVersion = 4;

/// The one symbol of the shared object, `polylumeImageLibrary`: null where the versions differ.
inline constexpr const char* kImageLibrarySymbol = "polylumeImageLibrary";
using ImageLibraryEntry = const ImageLibrary* (*)(int version);

}  // namespace polylume
