// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"

/// One fitted lobe: M^-1 = [[m11, 0, m13], [0, 1, 0], [m31, 0, m33]] in the shading frame, and what it reflects.
struct LtcLobe {
    float m11;
    float m13;
    float m31;
    float m33;
    float upperShare;  ///< H, the share of the lobe above the surface.
    float albedo;      ///< Directional albedo with Fresnel = 1.
    float fresnel;     ///< The same weighted by (1 - v.h)^5.
};

/// M^-1 v for a point, snapped to the lobe's horizon.
vec3 ltcTransform(LtcLobe lobe, vec3 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z));
}

/// M^-1 of a vector along the surface. Edges that share a point of the horizon get the same numbers for it.
vec3 ltcTransformHorizontal(LtcLobe lobe, vec2 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x, v.y, lobe.m31 * v.x));
}

/// The share of the light that the whole lobe reflects: F0 and F90 between Schlick's two ends.
vec3 ltcReflectance(LtcLobe lobe, vec3 f0, float f90) {
    return f0 * (lobe.albedo - lobe.fresnel) + f90 * lobe.fresnel;
}

/// The table's row coordinate sqrt(1 - cos theta_v), 0 to 1, of a unit normal and view. By the vectors' difference: the
/// cosine itself has lost the angle's digits near normal incidence, where a smooth lobe shows it.
float ltcViewCoordinate(vec3 normal, vec3 view) {
    vec3 difference = normal - view;
    return min(sqrt(0.5 * dot(difference, difference)), 0.99995);  // cos theta_v at least 1e-4.
}

/// Looks a table up: `matrices` holds m11, m13, m31, m33 and `albedos` albedo and fresnel, column = perceptual
/// roughness, row = ltcViewCoordinate(). The four texels are blended here, since filters of hardware weigh with 8 bits
/// only, which shows as bands on smooth surfaces.
LtcLobe ltcLookup(sampler2D matrices, sampler2D albedos, float roughness, float viewCoordinate) {
    ivec2 last = textureSize(matrices, 0) - 1;
    vec2 position = clamp(vec2(roughness, viewCoordinate), 0.0, 1.0) * vec2(last);
    ivec2 low = min(ivec2(position), max(last - 1, ivec2(0)));
    ivec2 high = min(low + 1, last);
    vec2 weight = position - vec2(low);

    vec4 matrix = mix(mix(texelFetch(matrices, low, 0), texelFetch(matrices, ivec2(high.x, low.y), 0), weight.x),
                      mix(texelFetch(matrices, ivec2(low.x, high.y), 0), texelFetch(matrices, high, 0), weight.x),
                      weight.y);
    vec2 albedo =
        mix(mix(texelFetch(albedos, low, 0).xy, texelFetch(albedos, ivec2(high.x, low.y), 0).xy, weight.x),
            mix(texelFetch(albedos, ivec2(low.x, high.y), 0).xy, texelFetch(albedos, high, 0).xy, weight.x), weight.y);

    LtcLobe lobe;
    lobe.m11 = matrix.x;
    lobe.m13 = matrix.y;
    lobe.m31 = matrix.z;
    lobe.m33 = matrix.w;
    lobe.upperShare = 0.5 + 0.5 * matrix.x * inversesqrt(matrix.x * matrix.x + matrix.z * matrix.z);
    lobe.albedo = albedo.x;
    lobe.fresnel = albedo.y;
    return lobe;
}
