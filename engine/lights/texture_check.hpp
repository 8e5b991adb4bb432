// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>

#include "polylume/light.hpp"

namespace polylume {

/// Throws Error that names polygon light `index`, which has a texture, where that has no image, or
/// one that checkLightImage() refuses.
void checkLightImage(const PolygonLight& light, std::size_t index);

/// The same where the texture's axes are not finite, in line, or out of the light's plane. A
/// contour is taken for granted.
void checkTextureAxes(const PolygonLight& light, std::size_t index);

/// Throws Error that names polygon light `index` where the image is of another size than its
/// texels, or a texel is negative or not finite.
void checkLightImage(const LightImage& image, std::size_t index);

}  // namespace polylume
