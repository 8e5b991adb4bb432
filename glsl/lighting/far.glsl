// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/lobes.glsl"
#include "shared/light_list_data.h"

#ifdef POLYLUME_LIGHT_LISTS
// Balls and tubes that are so far away, or so small, that a point in their middle stands for them within the threshold
// (culling/light_bound.glsl).

layout(binding = kLightNodeUnit) uniform usamplerBuffer lightNodes;

/// A far light as a point of the surface sees it.
struct FarLight {
    vec3 direction;  ///< Unit, in the shading frame.
    vec3 incidence;  ///< Radiance times solid angle.
};

FarLight farLight(uint node, vec3 positionWorld, mat3 frameFromWorld) {
    int texel = int(node * kLightNodeTexels);
    vec3 offset = uintBitsToFloat(texelFetch(lightNodes, texel).xyz) - positionWorld;
    vec3 radiance = uintBitsToFloat(texelFetch(lightNodes, texel + 3).xyz);
    vec4 tube = uintBitsToFloat(texelFetch(lightNodes, texel + 4));
    float inverse = inversesqrt(max(dot(offset, offset), 1e-30));
    offset *= inverse;
    // A ball is a tube without length.
    float area = tube.w * (2.0 * length(cross(tube.xyz, offset)) + 3.14159265 * tube.w);
    vec3 direction = frameFromWorld * offset;
    // A tile's list may have it for other surfaces than this one.
    area = direction.z > 0.0 ? area : 0.0;
    return FarLight(direction, radiance * (area * inverse * inverse));
}

/// A lobe's share of a far light's radiance times solid angle.
float farLobeFactor(FarLight light, LtcLobe lobe) {
    vec3 v = ltcTransformVector(lobe, light.direction);
    float determinant = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    float square = dot(v, v);
    return lobe.weight * determinant * max(v.z, 0.0) / (square * square) * 0.318309886;
}

vec2 farFactors(FarLight light, SurfaceLobes surface) {
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = farLobeFactor(light, surface.lobes[k]);
    return sumFactors(light.direction.z * 0.318309886, factors);
}
#endif
