// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/light.hpp"
#include "scene/scene.hpp"
#include "view/view_options.hpp"

namespace polylume {

/// The scene's lights and those that `options` adds. With `options.twoSided` every area light of
/// the scene emits from both sides.
LightSet lightsOf(const scene::Scene& scene, const ViewOptions& options);

}  // namespace polylume
