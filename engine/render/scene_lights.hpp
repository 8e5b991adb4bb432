// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "lighting/light.hpp"
#include "scene/scene.hpp"

namespace polylume {

/// The scene's lights as the lighting pass takes them; with `twoSided` every area light emits from
/// both sides.
LightSet lightsOf(const scene::Scene& scene, bool twoSided);

}  // namespace polylume
