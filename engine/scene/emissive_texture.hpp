// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "image/image.hpp"
#include "polylume/light.hpp"
#include "scene/material.hpp"
#include "scene/planar_patches.hpp"
#include "scene/welded_triangles.hpp"

namespace polylume::scene {

/// The emissive texture of a material as lights show it.
class EmissiveTexture {
  public:
    EmissiveTexture(const PixelImage& image, const Sampler& sampler);

    glm::ivec2 size() const { return image_->size; }

    /// Whether all texels in the box around these texture coordinates are black, up to 2/255.
    bool isBlack(const std::array<glm::dvec2, 3>& texCoords) const;

    /// Lays the texture on the light of a patch over which its coordinates are affine. One that the
    /// patch sees less than half a texel of becomes a factor of the light's radiance.
    void placeOn(const WeldedTriangles& welded, const Patch& patch, PolygonLight& light) const;

  private:
    std::uint32_t litTexels(int column, int row) const;

    std::shared_ptr<const LightImage> image_;
    TextureWrap wrapU_;
    TextureWrap wrapV_;
    std::vector<std::uint32_t> litCounts_;  ///< Of lit texels above and left of each, it included.
};

}  // namespace polylume::scene
