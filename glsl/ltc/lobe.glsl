// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"

// Reading a table: a sampler2DArray of float texels, column = perceptual roughness, row = view angle. Layer 0 holds the
// code of a lobe (stretch, tilt, shear, rootWidth), layer 1 albedo, fresnel and the second lobe's share, layer 2 the code
// of the second lobe. tables/README.md tells what they mean; the same is computed in double by ltc::Table::lookup().

/// One fitted lobe: M^-1 = [[m11, 0, m13], [0, 1, 0], [m31, 0, m33]] in the shading frame.
struct LtcLobe {
    float m11;
    float m13;
    float m31;
    float m33;
    float surfaceZ;  ///< z of the unit normal of the surface's plane after M^-1.
    float weight;    ///< Its share of the reflected light, divided by the share H of the lobe above the surface.
};

/// Where a table is read, and the direction that its lobes are stored relative to.
struct LtcPlace {
    ivec2 low;
    ivec2 high;
    vec2 blend;
    vec2 axis;  ///< (-sine, 0, cosine) in the shading frame: sine, cosine.
};

/// t = sqrt(1 - cos theta_v), 0 to 1, of a unit normal and view. By the vectors' difference: the cosine itself has lost
/// the angle's digits near normal incidence, where a smooth lobe shows it.
float ltcViewParameter(vec3 normal, vec3 view) {
    vec3 difference = normal - view;
    return min(sqrt(0.5 * dot(difference, difference)), 0.99995);  // cos theta_v at least 1e-4.
}

/// The place in a table of `size` texels for a roughness and ltcViewParameter(). `reference` tells how far the table's
/// lobes are from the normal, on the line to the mirror direction: x + y roughness^2.
LtcPlace ltcPlace(ivec2 size, vec2 reference, float roughness, float viewParameter) {
    float t = viewParameter;
    float r = clamp(roughness, 0.0, 1.0);
    // Rows are even in t / (t + u) with u = sqrt(cos theta_v).
    float cosine = 1.0 - t * t;
    ivec2 last = size - 1;
    vec2 position = vec2(r, t / (t + sqrt(cosine))) * vec2(last);
    LtcPlace place;
    place.low = min(ivec2(position), max(last - 1, ivec2(0)));
    place.high = min(place.low + 1, last);
    place.blend = position - vec2(place.low);

    float share = reference.x + reference.y * r * r;
    float sine = t * sqrt(2.0 - t * t);
    place.axis = normalize(vec2(share * sine, share * cosine + (1.0 - share)));
    return place;
}

/// The values of `layer` there. The four texels are blended here, since filters of hardware weigh with 8 bits only,
/// which shows as bands on smooth surfaces.
vec4 ltcFetch(highp sampler2DArray table, LtcPlace place, int layer) {
    vec4 lowLow = texelFetch(table, ivec3(place.low, layer), 0);
    vec4 highLow = texelFetch(table, ivec3(place.high.x, place.low.y, layer), 0);
    vec4 lowHigh = texelFetch(table, ivec3(place.low.x, place.high.y, layer), 0);
    vec4 highHigh = texelFetch(table, ivec3(place.high, layer), 0);
    return mix(mix(lowLow, highLow, place.blend.x), mix(lowHigh, highHigh, place.blend.x), place.blend.y);
}

/// The lobe of a stored code that carries `share` of the reflected light:
/// M^-1 = [[stretch, stretch tilt], [width shear, width (stretch + shear tilt)]] R with width = rootWidth^2 and R the
/// rotation that brings the axis to z.
LtcLobe ltcDecode(vec4 code, vec2 axis, float share) {
    float width = code.w * code.w;
    float n13 = code.x * code.y;
    float n31 = width * code.z;
    float n33 = width * (code.x + code.z * code.y);
    LtcLobe lobe;
    lobe.m11 = code.x * axis.y - n13 * axis.x;
    lobe.m13 = code.x * axis.x + n13 * axis.y;
    lobe.m31 = n31 * axis.y - n33 * axis.x;
    lobe.m33 = n31 * axis.x + n33 * axis.y;
    lobe.surfaceZ = lobe.m11 * inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    lobe.weight = share / (0.5 + 0.5 * lobe.surfaceZ);
    return lobe;
}

/// M^-1 v for a point, snapped to the lobe's horizon.
vec3 ltcTransform(LtcLobe lobe, vec3 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z));
}

/// M^-1 v for the vector from one point to another.
vec3 ltcTransformVector(LtcLobe lobe, vec3 v) {
    return vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z);
}

/// Where a point of the surface's plane after M^-1 lies in that plane: x along the image of the surface's x axis.
vec2 ltcAlongSurface(LtcLobe lobe, vec3 v) {
    return vec2((lobe.m11 * v.x + lobe.m31 * v.z) * inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31), v.y);
}

/// M^-1 of a vector along the surface. Edges that share a point of the horizon get the same numbers for it.
vec3 ltcTransformHorizontal(LtcLobe lobe, vec2 v) {
    return ltcSnapToHorizon(vec3(lobe.m11 * v.x, v.y, lobe.m31 * v.x));
}

/// The share of the light that a BRDF of these `albedos` (ltcFetch() of layer 1) reflects: F0 and F90 between Schlick's
/// two ends.
vec3 ltcReflectance(vec4 albedos, vec3 f0, float f90) { return f0 * (albedos.x - albedos.y) + f90 * albedos.y; }
