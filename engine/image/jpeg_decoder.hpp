// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "image/image.hpp"

namespace polylume {

/// The picture of a whole JPEG file as decodeImage() gives it. Throws Error that names `name`.
PixelImage decodeJpeg(std::span<const std::byte> encoded, std::string_view name);

}  // namespace polylume
