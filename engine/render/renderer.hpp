// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "context/context.hpp"
#include "core/progress.hpp"
#include "gl/shader_library.hpp"
#include "lighting/lighting_pass.hpp"
#include "ltc/table.hpp"
#include "scene/scene.hpp"
#include "view/view_options.hpp"

namespace polylume {

struct RenderOptions : ViewOptions {
    /// In place of the built-in one that `model` names.
    std::optional<ltc::Table> specularTable;
    /// As LightingPass::setLightThreshold() has it.
    std::optional<float> lightThreshold;
    /// Where there is none: what it shall be, from the log-mean luminance of a small picture by all
    /// lights, as RenderedImage has it. Empty, or with few lights: all lights it is.
    std::function<float(double logMeanLuminance)> chooseLightThreshold;
};

/// Throws Error where the driver does not draw pictures of `size` pixels.
void checkPictureSize(const gl::Functions& gl, glm::ivec2 size);

/// Draws `scene` as `camera` sees it, with `context` current. Throws Error where OpenGL reports
/// one, where the size is over the driver's limit, or a light is invalid.
RenderedImage renderScene(Context& context, const gl::ShaderLibrary& library,
                          const scene::Scene& scene, const scene::Camera& camera,
                          const RenderOptions& options, Progress& progress);

}  // namespace polylume
