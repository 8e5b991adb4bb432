// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <span>

#include "polylume/light_image.hpp"

namespace polylume::scene {

struct TexturedPoint {
    glm::dvec3 position{0.0};
    glm::dvec2 texCoord{0.0};
};

/// Texture coordinates that are affine over a plane.
class TexturePlane {
  public:
    /// The best fit, by least squares, to points around a plane with the unit normal `normal`. One
    /// point or more.
    TexturePlane(std::span<const TexturedPoint> points, const glm::dvec3& normal);

    glm::dvec2 at(const glm::dvec3& position) const;

    /// The largest distance of a point's texture coordinates from at(its position).
    double largestError(std::span<const TexturedPoint> points) const;

    /// The singular values of the change of texture coordinates per metre, the larger one first.
    glm::dvec2 stretch() const;

    /// The same plane with the smaller singular value raised to `least`, so that placeOn() exists
    /// where the coordinates change along one direction only. The larger one is above 0.
    TexturePlane withStretch(double least) const;

    /// Lays the image of `texture` over the plane. Both singular values are above 0. Coordinates
    /// move by whole periods of the wrap modes, to where single precision holds them best.
    void placeOn(LightTexture& texture) const;

  private:
    glm::dvec3 normal_;
    glm::dvec3 center_{0.0};
    glm::dvec2 atCenter_{0.0};
    glm::dvec3 gradientU_{0.0};  ///< In the plane, per metre.
    glm::dvec3 gradientV_{0.0};
};

}  // namespace polylume::scene
