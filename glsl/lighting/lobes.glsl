// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/frame.glsl"
#include "ltc/lobe.glsl"
#include "shared/light_data.h"
#include "surface/surface.glsl"

// The specular table's lobes, and after them the diffuse table's.
#ifdef POLYLUME_TWO_LOBES
const int kSpecularLobeCount = 2;
#else
const int kSpecularLobeCount = 1;
#endif
#if defined(POLYLUME_DIFFUSE_BURLEY) || defined(POLYLUME_DIFFUSE_OREN_NAYAR)
#define POLYLUME_DIFFUSE_TABLE
const int kLobeCount = kSpecularLobeCount + 1;
#else
const int kLobeCount = kSpecularLobeCount;
#endif

/// Of a surface towards its viewer.
struct SurfaceLobes {
    mat3 frameFromWorld;
    LtcLobe lobes[kLobeCount];
    vec3 reflectance;     ///< Of the specular reflection.
    float diffuseAlbedo;  ///< Of the diffuse one with a base colour of 1.
};

SurfaceLobes surfaceLobes(Surface surface) {
    SurfaceLobes result;
    result.frameFromWorld = ltcShadingFrame(surface.normalWorld, surface.viewWorld);
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(specularTable, 0).xy, lighting.lobeReferences.xy, surface.roughness, view);
    vec4 albedos = ltcFetch(specularTable, place, 1);
    result.reflectance = ltcReflectance(albedos, surface.f0, surface.f90);
    result.lobes[0] = ltcDecode(ltcFetch(specularTable, place, 0), place.axis, 1.0 - albedos.z);
#ifdef POLYLUME_TWO_LOBES
    result.lobes[1] = ltcDecode(ltcFetch(specularTable, place, 2), place.axis, albedos.z);
#endif
    result.diffuseAlbedo = 1.0;
#ifdef POLYLUME_DIFFUSE_TABLE
    place = ltcPlace(textureSize(diffuseTable, 0).xy, lighting.lobeReferences.zw, surface.roughness, view);
    result.diffuseAlbedo = ltcFetch(diffuseTable, place, 1).x;
    result.lobes[kSpecularLobeCount] = ltcDecode(ltcFetch(diffuseTable, place, 0), place.axis, 1.0);
#endif
    return result;
}

/// x: of the diffuse reflection, y: of the specular one.
vec2 sumFactors(float cosine, float factors[kLobeCount]) {
    vec2 sum = vec2(cosine, 0.0);
    for (int k = 0; k < kSpecularLobeCount; ++k) sum.y += factors[k];
#ifdef POLYLUME_DIFFUSE_TABLE
    sum.x = factors[kSpecularLobeCount];
#endif
    return sum;
}
