// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "context/context.hpp"
#include "core/progress.hpp"
#include "gl/shader_library.hpp"
#include "image/image.hpp"
#include "lighting/lighting_pass.hpp"
#include "ltc/table.hpp"
#include "scene/scene.hpp"

namespace polylume {

struct RenderOptions {
    glm::ivec2 size{1280, 720};
    int sampleCount = 4;  ///< Jittered frames that are averaged.
    Lobes lobes = Lobes::all;
    /// In place of the built-in one that `model` names.
    std::optional<ltc::Table> specularTable;
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

/// Draws `scene` as `camera` sees it, with `context` current. Throws Error where OpenGL reports
/// one, where the size is over the driver's limit, or a light is invalid.
RenderedImage renderScene(Context& context, const gl::ShaderLibrary& library,
                          const scene::Scene& scene, const scene::Camera& camera,
                          const RenderOptions& options, Progress& progress);

}  // namespace polylume
