// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kCameraBinding = 0;

/// A camera of either kind, jittered for one frame. A pixel's ray, for x and y of normalised device coordinates, is
/// rayOrigin + x rayOriginX + y rayOriginY + t (rayDirection + x rayDirectionX + y rayDirectionY), with t the distance
/// along the optical axis in metres, t = (depth.x + depth.y d) / (depth.z + depth.w d) for the depth buffer's d.
/// Depth is reversed: 1 near, 0 far.
struct CameraData {
    mat4 clipFromWorld;
    vec4 rayOrigin;
    vec4 rayOriginX;
    vec4 rayOriginY;
    vec4 rayDirection;
    vec4 rayDirectionX;
    vec4 rayDirectionY;
    vec4 depth;
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kCameraBinding) uniform CameraBlock { CameraData camera; };
#endif
