// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "scene/scene.hpp"
#include "shared/camera_data.h"

namespace polylume {

/// The camera block for a picture of `size` pixels whose pixels are sampled at `samplePosition` (0
/// to 1, x right, y down; 0.5 the centre). A perspective camera decides the height of the field of
/// view, and the picture's aspect ratio its width; all that an orthographic camera sees is fitted
/// into the picture.
shared::CameraData makeCameraData(const scene::Camera& camera, glm::ivec2 size,
                                  glm::dvec2 samplePosition);

}  // namespace polylume
