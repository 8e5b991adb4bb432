// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

namespace polylume {

/// A picture on a light: linear Rec. 709 factors of its radiance, finite and from 0.
struct LightImage {
    glm::ivec2 size{0};
    std::vector<glm::vec3> texels{};  ///< size.x * size.y, rows from the top.
};

/// What is beyond the edges of an image, as glTF samplers have it.
enum class TextureWrap { clampToEdge, repeat, mirroredRepeat };

/// How an image lies on a flat light: texture coordinates (u, v) are at origin + u axisU + v axisV
/// in the light's plane, within a thousandth of the axes. (0, 0) is the image's upper left corner,
/// (1, 1) its lower right one. The axes may be at any angle to each other but in line.
struct LightTexture {
    std::shared_ptr<const LightImage> image{};
    glm::vec3 origin{0.0f};
    glm::vec3 axisU{1.0f, 0.0f, 0.0f};
    glm::vec3 axisV{0.0f, 1.0f, 0.0f};
    TextureWrap wrapU = TextureWrap::clampToEdge;
    TextureWrap wrapV = TextureWrap::clampToEdge;
};

}  // namespace polylume
