// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light.glsl"
#include "ltc/frame.glsl"
#include "ltc/lobe.glsl"
#include "ltc/parallelogram.glsl"
#include "surface/surface.glsl"
// Includes are resolved before conditions are: what both sides need comes first.
#ifdef POLYLUME_POLYGON_LIGHTS
#include "ltc/polygon.glsl"
#endif

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

/// Parallelogram light `index` as the point sees it, and how it counts: 1 from the side that emits, -1 from the back of
/// one that emits from both, else 0.
LtcParallelogram clippedParallelogram(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    ParallelogramData light = parallelograms[index];
    vec3 corner = light.corner.xyz - positionWorld;
    side = lightSide(-dot(light.normal.xyz, corner), max(abs(corner.x), max(abs(corner.y), abs(corner.z))),
                     light.corner.w);
    return ltcClipParallelogram(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                frameFromWorld * light.edgeY.xyz);
}

/// Form factors of parallelogram `index` for the diffuse and the specular reflection, as light counts them. Rounding
/// leaves them up to a millionth below 0.
vec2 parallelogramFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogram outline = clippedParallelogram(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(outline), factors);
}

#ifdef POLYLUME_POLYGON_LIGHTS
/// The same for polygon `index`.
vec2 polygonFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    PolygonData light = polygons[index];
    float distance = dot(light.plane.xyz, positionWorld) + light.plane.w;
    vec3 normal = surface.frameFromWorld * light.plane.xyz;
    vec3 toPlane = distance > 0.0 ? -normal : normal;
    LtcPolygon polygon = ltcBeginPolygon(toPlane);
    LtcPolygonImage images[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) images[k] = ltcBeginImage(toPlane, surface.lobes[k]);
    vec3 reach = vec3(0.0);
    uint last = light.vertices.x + light.vertices.y;
    for (uint i = light.vertices.x; i < last; ++i) {
        vec4 vertex = polygonVertices[i];
        vec3 offset = vertex.xyz - positionWorld;
        reach = max(reach, abs(offset));
        LtcPolygonEdge edge = ltcAddVertex(surface.frameFromWorld * offset, vertex.w < 0.5, polygon);
        for (int k = 0; k < kLobeCount; ++k) ltcAddImageEdge(edge, surface.lobes[k], images[k]);
    }
    float side = lightSide(distance, max(reach.x, max(reach.y, reach.z)), light.radiance.w);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(images[k], surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(polygon), factors);
}
#endif

/// Adds what the surface reflects of all area lights.
void addAreaLights(Surface surface, SurfaceLobes lobes, inout Reflection reflection) {
    vec3 diffuse = vec3(0.0);
    vec3 specular = vec3(0.0);
    for (uint i = 0u; i < lighting.lightCount.x; ++i) {
        vec2 factors = clamp(parallelogramFactors(i, surface.positionWorld, lobes), 0.0, 1.0);
        diffuse += factors.x * parallelograms[i].radiance.rgb;
        specular += factors.y * parallelograms[i].radiance.rgb;
    }
#ifdef POLYLUME_POLYGON_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.y; ++i) {
        vec2 factors = clamp(polygonFactors(i, surface.positionWorld, lobes), 0.0, 1.0);
        diffuse += factors.x * polygons[i].radiance.rgb;
        specular += factors.y * polygons[i].radiance.rgb;
    }
#endif
    reflection.diffuse += lobes.diffuseAlbedo * diffuse;
    reflection.specular += lobes.reflectance * specular;
}
