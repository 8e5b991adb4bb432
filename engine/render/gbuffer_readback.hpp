// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"
#include "render/gbuffer.hpp"
#include "shared/camera_data.h"

namespace polylume {

/// What the lighting pass sees of a pixel, decoded as glsl/surface/gbuffer_read.glsl does it.
struct GBufferPixel {
    bool isSurface = false;  ///< False: background, and all below is zero.
    glm::vec3 positionWorld{0.0f};
    glm::vec3 normalWorld{0.0f};
    glm::vec3 viewWorld{0.0f};
    glm::vec3 diffuseAlbedo{0.0f};
    float roughness = 0.0f;
    glm::vec3 f0{0.0f};
    float f90 = 0.0f;
    glm::vec3 emission{0.0f};
    float occlusion = 0.0f;
    glm::vec3 sheenColor{0.0f};
    float sheenRoughness = 0.0f;
    float distance = 0.0f;  ///< Along the camera's axis, metres.
};

/// Every pixel, row by row from the top. The G-buffer was written with `camera`.
std::vector<GBufferPixel> readGBuffer(const GBuffer& gbuffer, const shared::CameraData& camera);

/// For every pixel, row by row from the top, whether it shows a surface that reflects anything.
std::vector<bool> findLitPixels(const GBuffer& gbuffer);

/// The names of the layers that appendAovs() knows.
std::vector<std::string_view> aovNames();

/// Appends the layers `names` of the G-buffer's values to `image`, which has its size: channels
/// "normal.X" and so on. Throws Error that lists the known names where one is unknown.
void appendAovs(const std::vector<GBufferPixel>& pixels, const std::vector<std::string>& names,
                FloatImage& image);

/// Throws Error that lists the known names where one of `names` is unknown.
void checkAovNames(const std::vector<std::string>& names);

}  // namespace polylume
