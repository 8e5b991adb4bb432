// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/image.hpp"
#include "polylume/light.hpp"
#include "polylume/lighting_model.hpp"

namespace polylume {

/// What every way to make a picture of a scene is asked for.
struct ViewOptions {
    glm::ivec2 size{1280, 720};
    int sampleCount = 4;  ///< Positions in a pixel (pixelSamples()) that are averaged.
    Lobes lobes = Lobes::all;
    LightingModel model;    ///< Whether it has sheen follows the scene.
    LightSet extraLights;   ///< Beside the scene's own: polygons with holes, single two-sided ones.
    bool twoSided = false;  ///< Every area light emits from both sides.
    bool hideLights = false;  ///< The camera does not see area lights.
    std::optional<glm::vec3> background = glm::vec3(0.0f);  ///< Nits; none: transparent.
    std::vector<std::string> aovs;                          ///< Layers of aovNames() to append.
};

struct RenderedImage {
    /// R, G, B in nits and A (coverage), colour times coverage; then the AOVs, sampled at pixel
    /// centres.
    FloatImage image;
    /// Log-mean luminance in nits of the pixels that show a lit opaque surface, or where there is
    /// none, of all; 0 where everything is black.
    double logMeanLuminance = 0.0;
};

}  // namespace polylume
