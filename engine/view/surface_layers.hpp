// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace polylume {

/// What lighting sees of a pixel.
struct SurfacePixel {
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

/// For every pixel whether it shows a surface that reflects anything.
std::vector<bool> litPixels(const std::vector<SurfacePixel>& pixels);

/// The log-mean luminance that exposure goes by: of the `lit` pixels, or where these are black, of
/// all.
double litLogMeanLuminance(const FloatImage& image, const std::vector<bool>& lit);

/// The names of the layers that appendAovs() knows.
std::vector<std::string_view> aovNames();

/// Appends the layers `names` of surfaces' values to `image`, which has its size: channels
/// "normal.X" and so on. Throws Error that lists the known names where one is unknown.
void appendAovs(const std::vector<SurfacePixel>& pixels, const std::vector<std::string>& names,
                FloatImage& image);

/// Throws Error that lists the known names where one of `names` is unknown.
void checkAovNames(const std::vector<std::string>& names);

}  // namespace polylume
