// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/texture_upload.hpp"

#include <bit>
#include <cstring>

#include "image/mip_level.hpp"
#include "image/srgb.hpp"

namespace polylume {
namespace {

constexpr GLenum kPixelFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};

/// Repeats grey to three channels and keeps alpha: 1 channel becomes 3, 2 become 4. `T` is the
/// channel's type.
template <typename T>
PixelImage expandGrey(const PixelImage& image) {
    PixelImage expanded = image;
    expanded.channelCount = image.channelCount + 2;
    const std::size_t pixelCount = static_cast<std::size_t>(image.width) * image.height;
    expanded.pixels.resize(pixelCount * expanded.channelCount * sizeof(T));
    for (std::size_t i = 0; i < pixelCount; ++i) {
        T source[2] = {};
        std::memcpy(source, image.pixels.data() + i * image.channelCount * sizeof(T),
                    image.channelCount * sizeof(T));
        const T target[4] = {source[0], source[0], source[0], source[1]};
        std::memcpy(expanded.pixels.data() + i * expanded.channelCount * sizeof(T), target,
                    expanded.channelCount * sizeof(T));
    }
    return expanded;
}

/// OpenGL decodes sRGB of 8 bits only, so 16 bits are made linear here.
void decodeSrgb16(PixelImage& image) {
    const std::size_t count = image.pixels.size() / 2;
    for (std::size_t i = 0; i < count; ++i) {
        const bool isAlpha = image.channelCount == 4 && i % 4 == 3;
        if (isAlpha) continue;
        std::uint16_t value = 0;
        std::memcpy(&value, image.pixels.data() + 2 * i, 2);
        value = static_cast<std::uint16_t>(linearFromSrgb(value / 65535.0f) * 65535.0f + 0.5f);
        std::memcpy(image.pixels.data() + 2 * i, &value, 2);
    }
}

GLenum internalFormat(const PixelImage& image, bool srgb) {
    constexpr GLenum kFormats8[] = {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8};
    constexpr GLenum kFormats16[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
    if (image.bitsPerChannel == 16) return kFormats16[image.channelCount - 1];
    if (srgb) return image.channelCount == 3 ? GL_SRGB8 : GL_SRGB8_ALPHA8;
    return kFormats8[image.channelCount - 1];
}

void setGreySwizzle(gl::Texture& texture, int channelCount) {
    if (channelCount > 2) return;
    texture.setParameter(GL_TEXTURE_SWIZZLE_G, GL_RED);
    texture.setParameter(GL_TEXTURE_SWIZZLE_B, GL_RED);
    texture.setParameter(GL_TEXTURE_SWIZZLE_A, channelCount == 2 ? GL_GREEN : GL_ONE);
}

gl::Texture upload(const gl::Functions& gl, const PixelImage& image, bool srgb, bool withMips) {
    const glm::ivec2 size(image.width, image.height);
    const int longest = std::max(size.x, size.y);
    const int levelCount = withMips ? std::bit_width(static_cast<unsigned>(longest)) : 1;
    gl::Texture texture(gl, internalFormat(image, srgb), size, levelCount, "material texture");
    const GLenum format = kPixelFormats[image.channelCount - 1];
    const GLenum type = image.bitsPerChannel == 16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE;
    texture.upload(format, type, image.pixels.data());
    // Not by glGenerateTextureMipmap(). For each format Mesa's drivers that run on the CPU compile
    // shaders first, which takes longer than this, and they round 8-bit means upwards: by 0.45 a
    // level (Mesa 22.3), which tilts normals by more than a degree at the sixth.
    PixelImage mip;
    for (int level = 1; level < levelCount; ++level) {
        mip = nextMipLevel(level == 1 ? image : mip, srgb);
        texture.uploadLevel(level, format, type, mip.pixels.data());
    }
    setGreySwizzle(texture, image.channelCount);
    return texture;
}

GLenum wrapMode(scene::Wrap wrap) {
    switch (wrap) {
        case scene::Wrap::repeat:
            return GL_REPEAT;
        case scene::Wrap::mirroredRepeat:
            return GL_MIRRORED_REPEAT;
        case scene::Wrap::clampToEdge:
            break;
    }
    return GL_CLAMP_TO_EDGE;
}

GLenum minFilter(const scene::Sampler& sampler) {
    const bool linear = sampler.minFilter == scene::Filter::linear;
    switch (sampler.mipFilter) {
        case scene::MipFilter::none:
            return linear ? GL_LINEAR : GL_NEAREST;
        case scene::MipFilter::nearest:
            return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
        case scene::MipFilter::linear:
            break;
    }
    return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
}

}  // namespace

gl::Texture uploadTexture(const gl::Functions& gl, const PixelImage& image,
                          scene::ColorSpace colorSpace, bool withMips) {
    if (colorSpace == scene::ColorSpace::linear) return upload(gl, image, false, withMips);
    // No sRGB format has fewer than three channels.
    const bool wide = image.bitsPerChannel == 16;
    if (image.channelCount > 2 && !wide) return upload(gl, image, true, withMips);
    PixelImage converted = image;
    if (image.channelCount <= 2) {
        converted = wide ? expandGrey<std::uint16_t>(image) : expandGrey<std::uint8_t>(image);
    }
    if (wide) decodeSrgb16(converted);
    return upload(gl, converted, !wide, withMips);
}

gl::SamplerObject makeSampler(const gl::Functions& gl, const scene::Sampler& sampler) {
    const GLenum magFilter = sampler.magFilter == scene::Filter::linear ? GL_LINEAR : GL_NEAREST;
    return {gl, magFilter, minFilter(sampler), wrapMode(sampler.wrapU), wrapMode(sampler.wrapV)};
}

}  // namespace polylume
