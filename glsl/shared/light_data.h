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
const uint kEllipseBinding = 4;
const uint kSphereBinding = 5;
const uint kTubeBinding = 6;
const uint kStorageBindingCount = 8;  // With kLightTextureBinding (shared/light_texture_data.h).
const uint kLightUnit = 9;
const uint kSpecularTableUnit = 10;
const uint kDiffuseTableUnit = 11;
const uint kSheenTableUnit = 12;

/// What holds for the whole pass.
struct LightingData {
    uvec4 lightCount;          ///< Parallelograms, polygons, punctual lights; w: how many of the polygons are triangles,
                               ///< the first ones.
    uvec4 roundLightCount;     ///< Ellipses, spheres, tubes; w: how many of the ellipses are disks, the first ones.
    uvec4 texturedLightCount;  ///< Parallelograms and polygons after those that lightCount counts; z: tiles that a picture
                               ///< with light lists is wide; w unused.
    uvec4 firstTexel;       ///< In lightTexels: of parallelograms, polygons, polygons' vertices, light textures.
    uvec4 firstRoundTexel;  ///< Of ellipses, spheres, tubes; w unused.
    vec4 textureScale;    ///< Of the images of lights: x: 1 / texels of a layer's side, y: the coarsest level; zw unused.
    vec4 lobeWeight;      ///< What is added up: diffuse, specular and sheen, emission, each 0 or 1; w: flatLobes().
    vec4 lobeReferences;  ///< Of ltcPlace(): xy of the specular table, zw of the diffuse one.
    vec4 sheenReference;  ///< xy; zw unused.
};

/// Emits from the side where corner, corner + edgeX, corner + edgeX + edgeY, ... turn counter-clockwise.
struct ParallelogramData {
    vec4 corner;    ///< w: 1 if both sides emit.
    vec4 edgeX;     ///< w: of a textured one, how many texels of its image go along it.
    vec4 edgeY;     ///< w: 1 if a surface in its place shows it.
    vec4 normal;    ///< Unit, to the emitting side; w: of a textured one, its image's layer.
    vec4 radiance;  ///< Nits; w: of a textured one, how many texels of its image go along edgeY.
};

/// Emits from the side where its outer contour turns counter-clockwise.
struct PolygonData {
    uvec4 vertices;  ///< First, and count; z: the largest distance of one from the first, as a float's bits; w: 1 if a
                     ///< surface in its place shows it.
    vec4 plane;      ///< Unit normal to the emitting side, and its offset: dot(normal, p) + w = 0.
    vec4 radiance;   ///< Nits; w: 1 if both sides emit.
};

/// Emits toward cross(halfAxisX, halfAxisY).
struct EllipseData {
    vec4 center;     ///< w: 1 if both sides emit.
    vec4 halfAxisX;  ///< At right angles to the other.
    vec4 halfAxisY;
    vec4 normal;     ///< Unit, to the emitting side.
    vec4 radiance;   ///< Nits.
};

struct SphereData {
    vec4 center;    ///< w: radius.
    vec4 radiance;  ///< Nits; w: 1 if it shines inwards, too.
};

/// A capsule around the line from start to start + axis.
struct TubeData {
    vec4 start;     ///< w: radius.
    vec4 axis;      ///< Its length may be 0.
    vec4 radiance;  ///< Nits; w: 1 if it shines inwards, too.
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
/// World positions; w is a contour's number of edges where it begins, else 0. A contour ends with its first vertex again.
layout(std430, binding = kPolygonVertexBinding) readonly buffer PolygonVertexBlock { vec4 polygonVertices[]; };
layout(std430, binding = kPunctualBinding) readonly buffer PunctualBlock { PunctualData punctuals[]; };
layout(std430, binding = kEllipseBinding) readonly buffer EllipseBlock { EllipseData ellipses[]; };
layout(std430, binding = kSphereBinding) readonly buffer SphereBlock { SphereData spheres[]; };
layout(std430, binding = kTubeBinding) readonly buffer TubeBlock { TubeData tubes[]; };
/// All blocks of lights one after the other. As bits: a texel of floats could lose those of a small integer.
layout(binding = kLightUnit) uniform usamplerBuffer lightTexels;
layout(binding = kSpecularTableUnit) uniform sampler2DArray specularTable;
layout(binding = kDiffuseTableUnit) uniform sampler2DArray diffuseTable;
layout(binding = kSheenTableUnit) uniform sampler2DArray sheenTable;
#endif
