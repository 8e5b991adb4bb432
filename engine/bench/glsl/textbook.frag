// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/frame.glsl"
#include "ltc/lobe.glsl"
#include "shared/light_data.h"
#include "surface/read_surface.glsl"

// What one writes first from the papers, as the measure of what is won: a rectangle's four corners are taken to the tangent
// frame and through M^-1 (Heitz et al. 2016, section 3), clipped at the horizon case by case, made unit, and the edges are
// summed (Lambert 1760; Baum et al. 1989, eq. 1); once with the identity for the diffuse reflection, once with the
// specular lobe. There is no clip at the surface before M^-1, so light from below it leaks into the specular reflection.
//
// As it stands, loops are unrolled by hand and the table is read once a pixel. With BENCH_LOOKUP_PER_LIGHT it is read in the
// function that is called for each light, with BENCH_LOOPS vertices and edges are gone through in loops of as many turns as
// the clip has left.

const int kMostTextbookLights = 64;

struct TextbookLight {
    vec4 corners[4];  ///< Counter-clockwise seen from the emitting side.
    vec4 radiance;    ///< Nits; w: 1 if both sides emit.
};

layout(std140, binding = 6) uniform TextbookBlock {
    uvec4 textbookCount;
    TextbookLight textbookLights[kMostTextbookLights];
};

layout(location = 0) out vec4 outRadiance;

/// Where the edge from `above` the horizon to `below` it crosses, at any positive length.
vec3 crossing(vec3 above, vec3 below) { return above.z * below - below.z * above; }

/// Leaves what is above z = 0 of the quad p[0..3] in p[0..n-1] and returns n, 0 to 5.
int clipAtHorizon(inout vec3 p[5]) {
    int above = 0;
    if (p[0].z > 0.0) above += 1;
    if (p[1].z > 0.0) above += 2;
    if (p[2].z > 0.0) above += 4;
    if (p[3].z > 0.0) above += 8;

    int count = 0;
    if (above == 0) {
    } else if (above == 15) {
        count = 4;
    } else if (above == 1) {
        count = 3;
        p[1] = crossing(p[0], p[1]);
        p[2] = crossing(p[0], p[3]);
    } else if (above == 2) {
        count = 3;
        p[0] = crossing(p[1], p[0]);
        p[2] = crossing(p[1], p[2]);
    } else if (above == 4) {
        count = 3;
        p[0] = crossing(p[2], p[3]);
        p[1] = crossing(p[2], p[1]);
    } else if (above == 8) {
        count = 3;
        p[0] = crossing(p[3], p[0]);
        p[1] = crossing(p[3], p[2]);
        p[2] = p[3];
    } else if (above == 3) {
        count = 4;
        p[2] = crossing(p[1], p[2]);
        p[3] = crossing(p[0], p[3]);
    } else if (above == 6) {
        count = 4;
        p[0] = crossing(p[1], p[0]);
        p[3] = crossing(p[2], p[3]);
    } else if (above == 12) {
        count = 4;
        p[1] = crossing(p[2], p[1]);
        p[0] = crossing(p[3], p[0]);
    } else if (above == 9) {
        count = 4;
        p[1] = crossing(p[0], p[1]);
        p[2] = crossing(p[3], p[2]);
    } else if (above == 7) {
        count = 5;
        p[4] = crossing(p[0], p[3]);
        p[3] = crossing(p[2], p[3]);
    } else if (above == 14) {
        count = 5;
        p[4] = crossing(p[3], p[0]);
        p[0] = crossing(p[1], p[0]);
    } else if (above == 13) {
        count = 5;
        p[4] = p[3];
        p[3] = p[2];
        p[2] = crossing(p[3], p[1]);
        p[1] = crossing(p[0], p[1]);
    } else if (above == 11) {
        count = 5;
        p[4] = p[3];
        p[3] = crossing(p[4], p[2]);
        p[2] = crossing(p[1], p[2]);
    }
    // 5 and 10 are no quad in a plane.
    if (count == 3) p[3] = p[0];
    if (count == 4) p[4] = p[0];
    return count;
}

/// z of the edge's angle times its plane's normal, `a` and `b` unit: theta / sin theta by a rational fit of
/// acos(x) / sqrt(1 - x^2) from 0 to 1, interpolated at Chebyshev's points (relative error 1.3e-6), and by
/// acos(-x) = pi - acos(x).
float edgeIntegral(vec3 a, vec3 b) {
    float x = dot(a, b);
    float y = abs(x);
    float ratio = (1.57079430 + (0.892072794 + 0.0248062309 * y) * y) / (1.0 + (1.20446407 + 0.283208680 * y) * y);
    if (x < 0.0) ratio = 3.14159265 * inversesqrt(max(1.0 - x * x, 1e-7)) - ratio;
    return cross(a, b).z * ratio;
}

/// The form factor of a light for the lobe whose M^-1 is `inverse`.
float textbookFactor(vec3 normal, vec3 view, vec3 position, mat3 inverse, TextbookLight light) {
    vec3 tangent = normalize(view - normal * dot(view, normal));
    vec3 bitangent = cross(normal, tangent);
    mat3 lobeFromWorld = inverse * transpose(mat3(tangent, bitangent, normal));

    vec3 p[5];
    p[0] = lobeFromWorld * (light.corners[0].xyz - position);
    p[1] = lobeFromWorld * (light.corners[1].xyz - position);
    p[2] = lobeFromWorld * (light.corners[2].xyz - position);
    p[3] = lobeFromWorld * (light.corners[3].xyz - position);
    p[4] = p[3];
    int count = clipAtHorizon(p);
    if (count == 0) return 0.0;

#ifdef BENCH_LOOPS
    float sum = 0.0;
    for (int i = 0; i < count; ++i) p[i] = normalize(p[i]);
    for (int i = 0; i < count; ++i) sum += edgeIntegral(p[i], p[(i + 1) % count]);
#else
    for (int i = 0; i < 5; ++i) p[i] = normalize(p[i]);
    float sum = edgeIntegral(p[0], p[1]) + edgeIntegral(p[1], p[2]) + edgeIntegral(p[2], p[3]);
    if (count >= 4) sum += edgeIntegral(p[3], p[4]);
    if (count == 5) sum += edgeIntegral(p[4], p[0]);
#endif
    sum = light.radiance.w > 0.5 ? abs(sum) : max(-sum, 0.0);
    return sum * 0.159154943;
}

/// What the table says of a surface.
struct TextbookLobe {
    mat3 inverse;
    vec3 specular;  ///< What factors for the lobe are multiplied with,
    vec3 diffuse;   ///< and those for the cosine.
};

TextbookLobe readLobe(Surface surface) {
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place = ltcPlace(textureSize(specularTable, 0).xy, lighting.lobeReferences.xy, surface.roughness, view);
    vec4 albedos = ltcFetch(specularTable, place, 1);
    LtcLobe lobe = ltcDecode(ltcFetch(specularTable, place, 0), place.axis, 1.0);
    vec3 reflectance = ltcReflectance(albedos, surface.f0, surface.f90);
    float rest = 1.0 - max(reflectance.r, max(reflectance.g, reflectance.b));
    mat3 inverse = mat3(lobe.m11, 0.0, lobe.m31, 0.0, 1.0, 0.0, lobe.m13, 0.0, lobe.m33);
    return TextbookLobe(inverse, lobe.weight * reflectance, rest * surface.diffuseAlbedo);
}

vec3 lightBy(TextbookLight light, Surface surface, TextbookLobe lobe) {
    vec3 position = surface.positionWorld;
    float diffuse = textbookFactor(surface.normalWorld, surface.viewWorld, position, mat3(1.0), light);
    float specular = textbookFactor(surface.normalWorld, surface.viewWorld, position, lobe.inverse, light);
    return light.radiance.rgb * (lobe.diffuse * diffuse + lobe.specular * specular);
}

void main() {
    Surface surface;
    bool isSurface = readSurface(ivec2(gl_FragCoord.xy), surface);
#ifndef BENCH_LOOKUP_PER_LIGHT
    TextbookLobe lobe = readLobe(surface);
#endif
    vec3 sum = surface.emission;
    uint i = 0u;
    do {
#ifdef BENCH_LOOKUP_PER_LIGHT
        TextbookLobe lobe = readLobe(surface);
#endif
        sum += lightBy(textbookLights[i], surface, lobe);
    } while (++i < textbookCount.x);
    outRadiance = vec4(sum, 1.0);
    if (!isSurface) discard;
}
