// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "scene/scene.hpp"

namespace polylume::scene {

/// A perspective camera that sees all of `bounds` from the front (glTF models face +Z), a little
/// from the right and above, as large as the picture of `aspectRatio` (width over height) lets it,
/// less a margin. Empty bounds are taken as a unit cube at the origin. Logs nothing: the caller
/// says that it framed one.
Camera frameCamera(const Bounds& bounds, float aspectRatio);

}  // namespace polylume::scene
