// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/area_lighting.hpp"
#include "shared/camera_data.h"

namespace polylume::embed {

/// What the lighting reads depth for.
enum class DepthUse {
    needed,   ///< For positions: it has to fall from near to far.
    optional  ///< CameraData::depth is 0 where it tells no distance. No camera is needed either.
};

/// The camera block of a host's matrices. A pixel's rays are those of a picture of which `scale`
/// times as many pixels lie side by side and above each other as the camera has, from the lower
/// left; (1, 1) for the camera's own. Throws Error where a matrix is not as LightingCamera says.
shared::CameraData makeCameraData(const LightingCamera& camera, DepthUse depthUse,
                                  glm::dvec2 scale = glm::dvec2(1.0));

}  // namespace polylume::embed
