// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "scene/emissive_texture.hpp"

#include <algorithm>
#include <cmath>

#include "image/srgb.hpp"
#include "lights/light_image_sampling.hpp"
#include "scene/light_texture_reader.hpp"
#include "scene/texture_plane.hpp"

namespace polylume::scene {
namespace {

/// Of the larger change of texture coordinates per metre, the least for the smaller one. Axes so
/// skewed are 2e-3 from parallel at the least; a light's have to be 1e-3.
constexpr double kLeastStretch = 1.5e-3;

// JPEG leaves such noise in what was black.
constexpr float kBlackCode = 2.0f / 255.0f;

/// First and last texel of a row of `size` between two coordinates; all where they go over an edge
/// of the image. What a filter reads half a texel beyond does not count.
std::array<int, 2> texelRange(double low, double high, int size, TextureWrap wrap) {
    constexpr double kRounding = 1e-3;  // Texels.
    const bool isPeriodic = wrap != TextureWrap::clampToEdge;
    const double period = isPeriodic ? std::floor(low + kRounding / size) : 0.0;
    const double first = std::floor((low - period) * size + kRounding);
    const double last = std::max(first, std::ceil((high - period) * size - kRounding) - 1.0);
    const bool isMirrored =
        wrap == TextureWrap::mirroredRepeat && period != 2.0 * std::floor(0.5 * period);
    if (isPeriodic && (isMirrored || last > size - 1.0)) return {0, size - 1};
    return {static_cast<int>(std::clamp(first, 0.0, size - 1.0)),
            static_cast<int>(std::clamp(last, 0.0, size - 1.0))};
}

}  // namespace

EmissiveTexture::EmissiveTexture(const PixelImage& image, const Sampler& sampler)
    : image_(std::make_shared<LightImage>(linearImage(image))),
      wrapU_(lightWrap(sampler.wrapU)),
      wrapV_(lightWrap(sampler.wrapV)) {
    const float black = linearFromSrgb(kBlackCode) * 1.001f;
    const auto width = static_cast<std::size_t>(image_->size.x);
    litCounts_.resize(image_->texels.size());
    for (std::size_t i = 0; i < litCounts_.size(); ++i) {
        const glm::vec3& texel = image_->texels[i];
        const bool isLit = std::max({texel.r, texel.g, texel.b}) > black;
        const std::uint32_t left = i % width > 0 ? litCounts_[i - 1] : 0;
        const std::uint32_t above = i >= width ? litCounts_[i - width] : 0;
        const std::uint32_t both = i % width > 0 && i >= width ? litCounts_[i - width - 1] : 0;
        litCounts_[i] = left + above - both + (isLit ? 1u : 0u);
    }
}

std::uint32_t EmissiveTexture::litTexels(int column, int row) const {
    if (column < 0 || row < 0) return 0;
    return litCounts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_->size.x) +
                      static_cast<std::size_t>(column)];
}

bool EmissiveTexture::isBlack(const std::array<glm::dvec2, 3>& texCoords) const {
    const glm::dvec2 low = glm::min(glm::min(texCoords[0], texCoords[1]), texCoords[2]);
    const glm::dvec2 high = glm::max(glm::max(texCoords[0], texCoords[1]), texCoords[2]);
    const std::array<int, 2> columns = texelRange(low.x, high.x, image_->size.x, wrapU_);
    const std::array<int, 2> rows = texelRange(low.y, high.y, image_->size.y, wrapV_);
    // The sums wrap around as the counts do.
    return litTexels(columns[1], rows[1]) - litTexels(columns[0] - 1, rows[1]) -
               litTexels(columns[1], rows[0] - 1) + litTexels(columns[0] - 1, rows[0] - 1) ==
           0;
}

void EmissiveTexture::placeOn(const WeldedTriangles& welded, const Patch& patch,
                              PolygonLight& light) const {
    std::vector<TexturedPoint> points;
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const int t : patch) {
        const SurfaceTriangle& triangle = welded.triangles[static_cast<std::size_t>(t)];
        for (std::size_t k = 0; k < 3; ++k) {
            points.push_back({triangle.positions[k], triangle.texCoords[k]});
            low = glm::min(low, triangle.positions[k]);
            high = glm::max(high, triangle.positions[k]);
        }
    }
    const TexturePlane plane(points, patchNormal(welded, patch));
    LightTexture texture;
    texture.image = image_;
    texture.wrapU = wrapU_;
    texture.wrapV = wrapV_;
    // Texture coordinates of a texel per metre of the patch.
    const double texelChange =
        1.0 / (std::max(image_->size.x, image_->size.y) * glm::length(high - low));
    if (plane.stretch().x < 0.5 * texelChange) {
        light.radiance *= glm::vec3(sampleImage(texture, plane.at(0.5 * (low + high))));
        return;
    }
    // Where the coordinates change along one direction alone, next to nothing across: the image's
    // axes have to span a plane.
    const double least = std::max(0.01 * texelChange, kLeastStretch * plane.stretch().x);
    plane.withStretch(least).placeOn(texture);
    light.texture = std::move(texture);
}

}  // namespace polylume::scene
