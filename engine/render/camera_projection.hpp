// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"
#include "shared/camera_data.h"

namespace polylume {

/// The camera block for a picture of `size` pixels whose pixels are sampled at `samplePosition` (0
/// to 1, x right, y down; 0.5 the centre). The picture's aspect ratio decides the field of view's
/// width; its height is the camera's.
shared::CameraData makeCameraData(const scene::Camera& camera, glm::ivec2 size,
                                  glm::dvec2 samplePosition);

}  // namespace polylume
