// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kLightTextureBinding = 7;
const uint kLightImageUnit = 13;
const uint kBakeSourceUnit = 14;
const uint kBakeCoverageUnit = 15;

// Uniforms of the passes that filter the images of lights.
const int kBakeTargetLocation = 0;
const int kBakeScaleLocation = 1;
const int kBakeOriginLocation = 2;
const int kBakeAxesLocation = 3;
const int kBakeReadsLocation = 4;
const int kBakeLargestLocation = 5;

/// How the filtered image lies on a textured polygon. Places in its frame go from (0, 0) at the corner to (1, 1). The frame
/// of a parallelogram is itself; ParallelogramData has what there is beside.
struct LightTextureData {
    vec4 corner;  ///< World position; w: the image's layer.
    vec4 edgeX;   ///< w: how many texels of the image go along it.
    vec4 edgeY;   ///< w: the same.
    vec4 spread;  ///< xy: the light's centre in the frame, zw: 1 / variance of its points.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std430, binding = kLightTextureBinding) readonly buffer LightTextureBlock { LightTextureData lightTextures[]; };
layout(binding = kLightImageUnit) uniform sampler2DArray lightImages;
#endif
