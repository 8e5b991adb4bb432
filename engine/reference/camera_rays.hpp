// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <limits>

#include "scene/scene.hpp"
#include "shared/camera_data.h"

namespace polylume::reference {

/// origin + t direction, from `nearest` to `farthest` in units of direction's length.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};
    double nearest = 0.0;
    double farthest = std::numeric_limits<double>::infinity();
    /// To the rays half a pixel to the right and half a pixel up, where the ray is the camera's.
    bool isFromCamera = false;
    glm::dvec3 originPerX{0.0}, originPerY{0.0};
    glm::dvec3 directionPerX{0.0}, directionPerY{0.0};
};

/// The rays of a camera through one position of all pixels: those that a rasteriser with the same
/// CameraData has. Their t is the distance along the camera's axis.
class CameraRays {
  public:
    CameraRays(const scene::Camera& camera, glm::ivec2 size, glm::dvec2 samplePosition);

    /// Through pixel (x, y), y from the top.
    Ray ray(int x, int y) const;

  private:
    shared::CameraData data_;
    glm::dvec2 size_;
    double nearest_, farthest_;
};

}  // namespace polylume::reference
