// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kLightingBinding = 3;
const uint kParallelogramBinding = 0;
const uint kPolygonBinding = 1;
const uint kPolygonVertexBinding = 2;
const uint kPunctualBinding = 3;
const uint kSpecularTableUnit = 10;
const uint kDiffuseTableUnit = 11;
const uint kSheenTableUnit = 12;

/// What holds for the whole pass.
struct LightingData {
    uvec4 lightCount;     ///< Parallelograms, polygons, punctual lights; w unused.
    vec4 lobeWeight;      ///< What is added up: diffuse, specular and sheen, emission, each 0 or 1; w unused.
    vec4 lobeReferences;  ///< Of ltcPlace(): xy of the specular table, zw of the diffuse one.
    vec4 sheenReference;  ///< xy; zw unused.
};

/// Emits from the side where corner, corner + edgeX, corner + edgeX + edgeY, ... turn counter-clockwise.
struct ParallelogramData {
    vec4 corner;    ///< w: 1 if both sides emit.
    vec4 edgeX;
    vec4 edgeY;
    vec4 normal;    ///< Unit, to the emitting side.
    vec4 radiance;  ///< Nits.
};

/// Emits from the side where its outer contour turns counter-clockwise.
struct PolygonData {
    uvec4 vertices;  ///< First, and count; zw unused.
    vec4 plane;      ///< Unit normal to the emitting side, and its offset: dot(normal, p) + w = 0.
    vec4 radiance;   ///< Nits; w: 1 if both sides emit.
};

/// A point, spot or directional light (KHR_lights_punctual).
struct PunctualData {
    vec4 position;   ///< w: 1 / range^2, 0 for no range.
    vec4 direction;  ///< Where the light goes; w: 1 for a directional light.
    vec4 intensity;  ///< Candela, or lux for a directional light.
    vec4 cone;       ///< Angular attenuation clamp(cos * x + y)^2.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kLightingBinding) uniform LightingBlock { LightingData lighting; };
layout(std430, binding = kParallelogramBinding) readonly buffer ParallelogramBlock { ParallelogramData parallelograms[]; };
layout(std430, binding = kPolygonBinding) readonly buffer PolygonBlock { PolygonData polygons[]; };
/// World positions; w is 1 where a contour begins. A contour ends with its first vertex again.
layout(std430, binding = kPolygonVertexBinding) readonly buffer PolygonVertexBlock { vec4 polygonVertices[]; };
layout(std430, binding = kPunctualBinding) readonly buffer PunctualBlock { PunctualData punctuals[]; };
layout(binding = kSpecularTableUnit) uniform sampler2DArray specularTable;
layout(binding = kDiffuseTableUnit) uniform sampler2DArray diffuseTable;
layout(binding = kSheenTableUnit) uniform sampler2DArray sheenTable;
#endif
