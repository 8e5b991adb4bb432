// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>

#include "polylume/light.hpp"

namespace polylume {

/// Throws Error that names polygon light `index` where it has a texture with no image, or one of
/// another size than its texels, or a texel that is negative or not finite, or axes that are not
/// finite, in line, or out of the light's plane. A contour is taken for granted.
void checkLightTexture(const PolygonLight& light, std::size_t index);

/// The same for an image alone.
void checkLightImage(const LightImage& image, std::size_t index);

}  // namespace polylume
