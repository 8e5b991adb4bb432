// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/texture_pyramid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "image/mip_level.hpp"
#include "image/srgb.hpp"

namespace polylume::reference {
namespace {

/// Linear values of the 8-bit codes.
using CodeTable = std::array<float, 256>;

CodeTable makeCodeTable(bool srgb) {
    CodeTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float value = static_cast<float>(i) / 255.0f;
        table[i] = srgb ? linearFromSrgb(value) : value;
    }
    return table;
}

float decode(std::uint32_t code, int bits, bool srgb) {
    static const CodeTable kLinear = makeCodeTable(false);
    static const CodeTable kSrgb = makeCodeTable(true);
    if (bits == 8) return (srgb ? kSrgb : kLinear)[code];
    const float value = static_cast<float>(code) / 65535.0f;
    return srgb ? linearFromSrgb(value) : value;
}

int wrap(int i, int size, scene::Wrap mode) {
    const auto modulo = [](int a, int b) { return (a % b + b) % b; };
    switch (mode) {
        case scene::Wrap::repeat:
            return modulo(i, size);
        case scene::Wrap::mirroredRepeat: {
            const int j = modulo(i, 2 * size);
            return j < size ? j : 2 * size - 1 - j;
        }
        case scene::Wrap::clampToEdge:
            break;
    }
    return std::clamp(i, 0, size - 1);
}

/// A texture coordinate in texels, kept where integers can count.
float inTexels(float coordinate, int size) {
    return std::clamp(coordinate * static_cast<float>(size), -1e9f, 1e9f);
}

}  // namespace

TexturePyramid::TexturePyramid(const PixelImage& image, const scene::Texture& texture)
    : image_(image),
      sampler_(texture.sampler),
      isSrgb_(texture.colorSpace == scene::ColorSpace::srgb) {
    levels_.push_back({image.width, image.height, image.pixels.data()});
    if (sampler_.mipFilter == scene::MipFilter::none) return;
    // A deque: each level is made from one in it.
    const PixelImage* above = &image_;
    while (above->width > 1 || above->height > 1) {
        above = &storage_.emplace_back(nextMipLevel(*above, isSrgb_));
        levels_.push_back({above->width, above->height, above->pixels.data()});
    }
}

std::uint32_t TexturePyramid::code(const Level& level, int x, int y, int channel) const {
    const std::size_t index =
        (static_cast<std::size_t>(y) * level.width + x) * image_.channelCount + channel;
    if (image_.bitsPerChannel == 8) return level.texels[index];
    std::uint16_t value = 0;
    std::memcpy(&value, level.texels + 2 * index, 2);
    return value;
}

glm::vec4 TexturePyramid::texel(const Level& level, int x, int y) const {
    x = wrap(x, level.width, sampler_.wrapU);
    y = wrap(y, level.height, sampler_.wrapV);
    const int bits = image_.bitsPerChannel;
    const auto color = [&](int c) { return decode(code(level, x, y, c), bits, isSrgb_); };
    const auto alpha = [&](int c) { return decode(code(level, x, y, c), bits, false); };
    switch (image_.channelCount) {
        case 1:
            return {glm::vec3(color(0)), 1.0f};
        case 2:
            return {glm::vec3(color(0)), alpha(1)};
        case 3:
            return {color(0), color(1), color(2), 1.0f};
        default:
            return {color(0), color(1), color(2), alpha(3)};
    }
}

glm::vec4 TexturePyramid::nearest(const Level& level, const glm::vec2& uv) const {
    return texel(level, static_cast<int>(std::floor(inTexels(uv.x, level.width))),
                 static_cast<int>(std::floor(inTexels(uv.y, level.height))));
}

glm::vec4 TexturePyramid::linear(const Level& level, const glm::vec2& uv) const {
    const float x = inTexels(uv.x, level.width) - 0.5f, y = inTexels(uv.y, level.height) - 0.5f;
    const float floorX = std::floor(x), floorY = std::floor(y);
    const int column = static_cast<int>(floorX), row = static_cast<int>(floorY);
    const glm::vec4 top =
        glm::mix(texel(level, column, row), texel(level, column + 1, row), x - floorX);
    const glm::vec4 bottom =
        glm::mix(texel(level, column, row + 1), texel(level, column + 1, row + 1), x - floorX);
    return glm::mix(top, bottom, y - floorY);
}

glm::vec4 TexturePyramid::filtered(std::size_t level, scene::Filter filter,
                                   const glm::vec2& uv) const {
    return filter == scene::Filter::linear ? linear(levels_[level], uv)
                                           : nearest(levels_[level], uv);
}

glm::vec4 TexturePyramid::sample(const glm::vec2& uv, const glm::vec2& uvPerX,
                                 const glm::vec2& uvPerY) const {
    const glm::vec2 size(levels_[0].width, levels_[0].height);
    // The level of detail (eq. 8.5 to 8.8).
    const float rho = std::max(glm::length(size * uvPerX), glm::length(size * uvPerY));
    const float lambda = rho > 0.0f ? std::log2(rho) : -INFINITY;
    const bool minNearest = sampler_.minFilter == scene::Filter::nearest &&
                            sampler_.mipFilter != scene::MipFilter::none;
    const bool magLinear = sampler_.magFilter == scene::Filter::linear;
    if (!(lambda > (magLinear && minNearest ? 0.5f : 0.0f))) {
        return filtered(0, sampler_.magFilter, uv);
    }
    const float last = static_cast<float>(levels_.size() - 1);
    if (sampler_.mipFilter == scene::MipFilter::linear) {
        const float level = std::min(lambda, last);
        const auto below = static_cast<std::size_t>(level);
        const std::size_t above = std::min(below + 1, levels_.size() - 1);
        return glm::mix(filtered(below, sampler_.minFilter, uv),
                        filtered(above, sampler_.minFilter, uv), level - static_cast<float>(below));
    }
    const float level = std::clamp(std::ceil(lambda + 0.5f) - 1.0f, 0.0f, last);
    return filtered(static_cast<std::size_t>(level), sampler_.minFilter, uv);
}

}  // namespace polylume::reference
