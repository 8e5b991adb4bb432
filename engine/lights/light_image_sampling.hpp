// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/light_image.hpp"

namespace polylume {

/// The texture coordinates of a point of the light's plane.
glm::dvec2 textureCoordinates(const LightTexture& texture, const glm::dvec3& point);

/// The image there, linear between the centres of its texels; for any coordinates a mean of texels.
glm::dvec3 sampleImage(const LightTexture& texture, const glm::dvec2& coordinates);

}  // namespace polylume
