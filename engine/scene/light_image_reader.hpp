// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "image/image.hpp"
#include "polylume/light_image.hpp"

namespace polylume::scene {

/// Whether the bytes begin as an OpenEXR does.
bool isExr(std::span<const std::byte> bytes);

/// The picture on a light, from an sRGB-encoded PNG or JPEG; alpha is passed over.
LightImage linearImage(const PixelImage& image);

/// The same from an OpenEXR's channels R, G and B, or Y alone. Texels that are negative or not
/// finite become 0, and `warn` hears of it. Throws Error with `place` where the channels are
/// others.
LightImage linearImage(const FloatImage& image, std::string_view place,
                       const std::function<void(const std::string&)>& warn);

/// A file for a light to show: an OpenEXR in linear light, a PNG or a JPEG, told apart by content.
/// Throws Error that names the file.
LightImage readLightImage(const std::filesystem::path& path);

}  // namespace polylume::scene
