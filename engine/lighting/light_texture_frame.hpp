// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "polylume/light.hpp"

namespace polylume {

/// The parallelogram that the filtered image of a textured light covers, and what of it the light
/// is. Places in it go from (0, 0) at its corner to (1, 1).
struct LightTextureFrame {
    glm::dvec3 corner{0.0};
    glm::dvec3 edgeX{0.0};
    glm::dvec3 edgeY{0.0};
    glm::dvec2 textureOrigin{0.0};  ///< Texture coordinates of the corner,
    glm::dvec2 textureX{0.0};       ///< and what the edges add to them.
    glm::dvec2 textureY{0.0};
    glm::ivec2 size{1};      ///< Texels that do the image justice: powers of two, to kLargestSize.
    glm::dvec2 center{0.5};  ///< Of the light,
    glm::dvec2 variance{1.0 / 12.0};  ///< and the variance of its points.
    /// Contours in those places; empty where the light is all of the parallelogram.
    std::vector<std::vector<glm::dvec2>> contours;

    static constexpr int kLargestSize = 1024;
};

/// The frame of a light with a texture; `isParallelogram` where its outline is one.
LightTextureFrame lightTextureFrame(const PolygonLight& light, bool isParallelogram);

/// Where a frame lies.
struct LightFrameEdges {
    glm::dvec3 corner{0.0};
    glm::dvec3 edgeX{0.0};
    glm::dvec3 edgeY{0.0};
};

/// Where the frame of `light`, moved from where `frame` was made for it, lies now; nothing where
/// its image does not lie on it as before, within a tenth of a texel: another size, another
/// outline, or another place or wrapping of the texture. Allocates nothing. The texture's image is
/// not looked at.
std::optional<LightFrameEdges> movedFrame(const PolygonLight& light, bool isParallelogram,
                                          const LightTextureFrame& frame,
                                          const LightTexture& textureBefore);

/// How much of each texel of `frame.size` the light covers, 0 to 255, rows from that of place
/// y = 0. Even-odd rule.
std::vector<std::uint8_t> lightCoverage(const LightTextureFrame& frame);

}  // namespace polylume
