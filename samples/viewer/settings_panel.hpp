// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene_document.hpp"
#include "split_view.hpp"
#include "view_renderer.hpp"
#include "view_settings.hpp"

namespace polylume::viewer {

/// Draws the controls of how the scene is lit and shown into the current ImGui window; they change
/// `settings`.
void drawLightingControls(ViewSettings& settings);
/// `ev`: that is shown now.
void drawDisplayControls(ViewSettings& settings, double ev);
void drawMaterialControls(ViewSettings& settings);
void drawReferenceControls(SplitView& split);
/// The cameras of the scene; returns the index of one that was picked, or -1.
int drawCameraControls(const scene::Scene& cameras, int current);

/// What keys step through.
Lobes nextLobes(Lobes lobes);
ToneMap nextToneMap(ToneMap toneMap);

}  // namespace polylume::viewer
