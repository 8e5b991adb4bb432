// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <deque>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.hpp"
#include "scene/material.hpp"

namespace polylume::reference {

/// A texture as OpenGL 4.5 (section 8.14) filters it: wrapped, minified through mip levels that are
/// stored with the bits of the image, without anisotropy.
class TexturePyramid {
  public:
    /// Keeps a reference to `image`.
    TexturePyramid(const PixelImage& image, const scene::Texture& texture);

    /// Linear red, green, blue and alpha at `uv`, which changes by `uvPerX` and `uvPerY` from pixel
    /// to pixel; zero for both asks for the full resolution.
    glm::vec4 sample(const glm::vec2& uv, const glm::vec2& uvPerX, const glm::vec2& uvPerY) const;

  private:
    struct Level {
        int width, height;
        const std::uint8_t* texels;
    };

    std::uint32_t code(const Level& level, int x, int y, int channel) const;
    glm::vec4 texel(const Level& level, int x, int y) const;
    glm::vec4 nearest(const Level& level, const glm::vec2& uv) const;
    glm::vec4 linear(const Level& level, const glm::vec2& uv) const;
    glm::vec4 filtered(std::size_t level, scene::Filter filter, const glm::vec2& uv) const;

    const PixelImage& image_;
    scene::Sampler sampler_;
    bool isSrgb_;
    std::deque<PixelImage> storage_;  ///< Of the levels above 0.
    std::vector<Level> levels_;
};

}  // namespace polylume::reference
