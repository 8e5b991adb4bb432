// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "surface/octahedral.glsl"
#include "surface/surface.glsl"

layout(binding = 0) uniform sampler2D gbufferNormal;
layout(binding = 1) uniform sampler2D gbufferDiffuseRoughness;
layout(binding = 2) uniform sampler2D gbufferSpecular;
layout(binding = 3) uniform sampler2D gbufferEmission;
layout(binding = 4) uniform sampler2D gbufferDepth;
#ifdef POLYLUME_SHEEN
layout(binding = 5) uniform sampler2D gbufferSheen;
#endif

Surface readGBuffer(ivec2 pixel) {
    vec2 ndc = (vec2(pixel) + 0.5) / vec2(textureSize(gbufferDepth, 0)) * 2.0 - 1.0;
    float depth = texelFetch(gbufferDepth, pixel, 0).x;
    float distance = (camera.depth.x + camera.depth.y * depth) / (camera.depth.z + camera.depth.w * depth);
    vec3 rayOrigin = camera.rayOrigin.xyz + ndc.x * camera.rayOriginX.xyz + ndc.y * camera.rayOriginY.xyz;
    vec3 rayDirection = camera.rayDirection.xyz + ndc.x * camera.rayDirectionX.xyz + ndc.y * camera.rayDirectionY.xyz;

    vec4 diffuseRoughness = texelFetch(gbufferDiffuseRoughness, pixel, 0);
    vec4 specular = texelFetch(gbufferSpecular, pixel, 0);
    vec4 emission = texelFetch(gbufferEmission, pixel, 0);

    Surface surface;
    surface.positionWorld = rayOrigin + distance * rayDirection;
    surface.normalWorld = octahedralDecode(texelFetch(gbufferNormal, pixel, 0).xy);
    surface.viewWorld = -normalize(rayDirection);
    surface.diffuseAlbedo = diffuseRoughness.xyz;
    surface.roughness = diffuseRoughness.w;
    surface.f0 = specular.xyz;
    surface.f90 = specular.w;
    surface.emission = emission.xyz;
    surface.occlusion = emission.w;
    vec4 sheen = vec4(0.0);
#ifdef POLYLUME_SHEEN
    sheen = texelFetch(gbufferSheen, pixel, 0);
#endif
    surface.sheenColor = sheen.xyz;
    surface.sheenRoughness = sheen.w;
    return surface;
}
