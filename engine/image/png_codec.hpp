// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace polylume {

/// The picture of a whole PNG file as decodeImage() gives it. Throws Error that names `name`.
PixelImage decodePng(std::span<const std::byte> encoded, std::string_view name);

/// A whole PNG file of an 8-bit image of 3 or 4 channels, sRGB-encoded, with `metadata` as text
/// chunks. Throws Error, without a name, for names of metadata that PNG forbids.
std::vector<std::byte> encodePng(const PixelImage& image, const ImageMetadata& metadata);

}  // namespace polylume
