// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace polylume::scene {

/// Three rectangles, key, fill and rim, fitted to `bounds` and placed by the camera's view: a large
/// warm one from the upper left, a weaker cool one from the right, and one from above behind that
/// draws the edges. They aim at the centre of `bounds` and stay out of a picture of that camera up
/// to 2:1, as far as it looks at `bounds` from outside. A white diffuse surface toward the key
/// reflects about 1000 nits. Empty bounds are taken as a unit cube at the origin. Logs nothing: the
/// caller says that it lit the scene.
std::vector<AreaLight> defaultRig(const Bounds& bounds, const Camera& camera);

}  // namespace polylume::scene
