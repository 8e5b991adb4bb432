// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/scene.hpp"

namespace polylume::scene {

/// Adds all lights of `lights` to `scene`, and, where `scene` has no camera, all its cameras.
/// Meshes and materials of `lights` are left behind. Logs nothing.
void addLightsFrom(Scene& scene, const Scene& lights);

}  // namespace polylume::scene
