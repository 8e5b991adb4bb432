// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "scene_document.hpp"
#include "view_renderer.hpp"

namespace polylume::viewer {

/// Draws into the current ImGui window what the picture costs: times of passes on the GPU, lights
/// per second, and counts. `backend`: what OpenGL says of itself.
void drawStatistics(ViewRenderer& renderer, const SceneDocument& document, double frameMilliseconds,
                    const std::string& backend);

/// Lights that shade one pixel each, per second: lights times lit pixels of a full picture, over
/// the time of the lighting pass on the GPU; 0 while that is not known.
double lightsPerSecond(int lightCount, int litPixelCount, double lightingMilliseconds);

}  // namespace polylume::viewer
