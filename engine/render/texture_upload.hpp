// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/objects.hpp"
#include "image/image.hpp"
#include "scene/material.hpp"

namespace polylume {

/// Uploads an image for a slot of the given colour space, with mip levels where `withMips`. Grey
/// images read as grey, a second channel as alpha. sRGB is decoded by the sampler, and before the
/// mip levels are averaged.
gl::Texture uploadTexture(const gl::Functions& gl, const PixelImage& image,
                          scene::ColorSpace colorSpace, bool withMips);

gl::SamplerObject makeSampler(const gl::Functions& gl, const scene::Sampler& sampler);

}  // namespace polylume
