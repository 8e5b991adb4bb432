// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/flat.glsl"
#include "lighting/light.glsl"
#include "lighting/light_image.glsl"
#include "lighting/lobes.glsl"
#include "lighting/read_lights.glsl"
#include "ltc/seen_parallelogram.glsl"
#include "ltc/seen_polygon.glsl"

// Parallelograms and polygons with an image. Colours are mean factors of the radiance times form factors.

// Variance of the directions of a clamped cosine, per angle: what came closest to ray-traced pictures. 0.25 is that of the
// cosine's projection on the unit disk; what M makes of it has heavy tails, for which two normal distributions do better.
const float kDiffuseVariance = 0.3;
const float kLobeVariance = 0.7;
const float kLobeCoreVariance = 0.35;
const float kLobeTailVariance = 2.0;
const float kLobeTailShare = 0.35;
// The same for a single read.
const float kGlancedDiffuseVariance = 0.25;

/// For the two reflections.
struct LightColors {
    vec3 diffuse;
    vec3 specular;
};

vec3 seenColor(LtcSight sight, float side, vec4 spread, LightImage image, float variance) {
    float factor = clamp(side * sight.factor, 0.0, 1.0);
    return factor * lightImageMean(image, ltcFootprint(sight.direction, sight.frame, spread, variance));
}

#ifdef POLYLUME_TWO_LOBES
vec3 seenSpecularColor(LtcSight sight, float side, vec4 spread, LightImage image) {
    vec3 core = seenColor(sight, side, spread, image, kLobeCoreVariance);
    return mix(core, seenColor(sight, side, spread, image, kLobeTailVariance), kLobeTailShare);
}
#endif

#ifndef POLYLUME_TWO_LOBES
vec3 glancedMean(LtcSight sight, LtcLobe lobe, LtcFrame frame, LightImage image, float variance) {
    float volume = dot(frame.corner, frame.normal);
    float inverseVolume = (volume < 0.0 ? -1.0 : 1.0) / max(abs(volume), 1e-15);
    return lightImageAtAGlance(image, ltcGlance(lobe, sight.direction, frame, inverseVolume), variance);
}

/// The mean factors of the radiance on a parallelogram; `factors` are its form factors, for the diffuse and the specular
/// reflection.
LightColors glancedMeans(LtcParallelogramEdges edges, SurfaceLobes surface, LightImage image, out vec2 factors) {
    LtcSurfaceClip clip;
    LtcLobe cosineLobe = LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0);
    LtcSight cosine = ltcSeeCosine(edges, clip);
    LtcSight sight = ltcSee(edges, clip, surface.lobes[0]);
#ifdef POLYLUME_DIFFUSE_TABLE
    cosineLobe = surface.lobes[kSpecularLobeCount];
    cosine = ltcSee(edges, clip, cosineLobe);
#endif
    factors = vec2(cosine.factor, sight.factor);
    return LightColors(glancedMean(cosine, cosineLobe, edges.frame, image, kGlancedDiffuseVariance),
                       glancedMean(sight, surface.lobes[0], edges.frame, image, kLobeVariance));
}
#endif

#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
/// A parallelogram's points are even over its frame.
const vec4 kEvenSpread = vec4(0.5, 0.5, 12.0, 12.0);

LtcParallelogramEdges texturedEdges(ParallelogramData light, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    vec3 corner = light.corner.xyz - positionWorld;
    side = lightSide(-dot(light.normal.xyz, corner), largestOf(corner), light.corner.w);
    return ltcParallelogramEdges(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                 frameFromWorld * light.edgeY.xyz);
}

#ifdef POLYLUME_TWO_LOBES
LightColors texturedParallelogramColors(ParallelogramData light, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, surface.frameFromWorld, side);
    LightImage image = LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w));
    LtcSurfaceClip clip;
    LtcSight cosine = ltcSeeCosine(edges, clip);
    LightColors colors = LightColors(vec3(0.0), vec3(0.0));
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        LtcSight sight = ltcSee(edges, clip, surface.lobes[k]);
        colors.specular += seenSpecularColor(sight, side, kEvenSpread, image);
    }
#ifdef POLYLUME_DIFFUSE_TABLE
    cosine = ltcSee(edges, clip, surface.lobes[kSpecularLobeCount]);
#endif
    colors.diffuse = seenColor(cosine, side, kEvenSpread, image, kDiffuseVariance);
    return colors;
}
#else
LightColors texturedParallelogramColors(ParallelogramData light, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, surface.frameFromWorld, side);
    vec2 factors;
    LightColors means = glancedMeans(edges, surface, LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w)),
                                     factors);
    factors = clamp(side * factors, 0.0, 1.0);
    return LightColors(factors.x * means.diffuse, factors.y * means.specular);
}
#endif

vec3 texturedParallelogramLobeColor(ParallelogramData light, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcParallelogramEdges edges = texturedEdges(light, positionWorld, frameFromWorld, side);
    LightImage image = LightImage(light.normal.w, vec2(light.edgeX.w, light.radiance.w));
    LtcSurfaceClip clip;
    ltcSeeCosine(edges, clip);
    return seenColor(ltcSee(edges, clip, lobe), side, kEvenSpread, image, kDiffuseVariance);
}
#endif

#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
/// Where the light of a polygon comes from, for a lobe of the form factor `factor`.
LtcMoments texturedPolygonMoments(PolygonData light, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe,
                                  float factor) {
    vec3 normal = frameFromWorld * light.plane.xyz;
    float distance = dot(light.plane.xyz, positionWorld) + light.plane.w;
    vec2 toPlane = distance > 0.0 ? -normal.xy : normal.xy;
    float square = dot(toPlane, toPlane);
    vec2 reference = square > 1e-20 ? toPlane * inversesqrt(square) : vec2(1.0, 0.0);
    LtcMoments moments = ltcNoMoments();
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    do {
        vec3 from = ltcSnapToHorizon(frameFromWorld * (begin.xyz - positionWorld));
        uint last = i + uint(begin.w);
        do {
            vec3 to = ltcSnapToHorizon(frameFromWorld * (polygonVertex(++i).xyz - positionWorld));
            ltcSeePolygonEdge(from, to, reference, lobe, moments);
            from = to;
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    moments.sum = (distance > 0.0 ? -6.28318531 : 6.28318531) * abs(factor) / lobe.weight;
    return moments;
}

/// What the lobe sees of polygon light `index`.
LtcSight texturedPolygonSight(uint index, LightTextureData data, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float factor = polygonLobeFactor(index, positionWorld, frameFromWorld, lobe);
    LtcMoments moments = texturedPolygonMoments(polygonLight(index), positionWorld, frameFromWorld, lobe, factor);
    vec3 corner = frameFromWorld * (data.corner.xyz - positionWorld);
    LtcFrame frame =
        ltcFrame(ltcTransformVector(lobe, corner), ltcTransformVector(lobe, frameFromWorld * data.edgeX.xyz),
                 ltcTransformVector(lobe, frameFromWorld * data.edgeY.xyz));
    return LtcSight(factor, ltcMeanDirection(moments), frame);
}

LightImage polygonImage(LightTextureData data) {
    return LightImage(data.corner.w, vec2(data.edgeX.w, data.edgeY.w));
}

/// What the lobe reflects of polygon light `index`, per radiance.
vec3 texturedPolygonLobeColor(uint index, LightTextureData data, vec3 positionWorld, mat3 frameFromWorld,
                              LtcLobe lobe, float variance) {
    LtcSight sight = texturedPolygonSight(index, data, positionWorld, frameFromWorld, lobe);
    return seenColor(sight, 1.0, data.spread, polygonImage(data), variance);
}

#ifdef POLYLUME_TWO_LOBES
LightColors texturedPolygonColors(uint index, LightTextureData data, vec3 positionWorld, SurfaceLobes surface) {
    mat3 frame = surface.frameFromWorld;
    LightColors colors = LightColors(vec3(0.0), vec3(0.0));
    for (int k = 0; k < kSpecularLobeCount; ++k) {
        LtcSight sight = texturedPolygonSight(index, data, positionWorld, frame, surface.lobes[k]);
        colors.specular += seenSpecularColor(sight, 1.0, data.spread, polygonImage(data));
    }
#ifdef POLYLUME_DIFFUSE_TABLE
    LtcLobe cosine = surface.lobes[kSpecularLobeCount];
#else
    LtcLobe cosine = LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0);
#endif
    colors.diffuse = texturedPolygonLobeColor(index, data, positionWorld, frame, cosine, kDiffuseVariance);
    return colors;
}
#else
/// As if the light were all of its frame, as far as the place on the image is concerned.
LightColors texturedPolygonColors(uint index, LightTextureData data, vec3 positionWorld, SurfaceLobes surface) {
    mat3 frame = surface.frameFromWorld;
    LtcParallelogramEdges edges = ltcParallelogramEdges(frame * (data.corner.xyz - positionWorld),
                                                        frame * data.edgeX.xyz, frame * data.edgeY.xyz);
    vec2 factors;
    LightColors means = glancedMeans(edges, surface, polygonImage(data), factors);
    factors = clamp(polygonFactors(index, positionWorld, surface), 0.0, 1.0);
    return LightColors(factors.x * means.diffuse, factors.y * means.specular);
}
#endif
#endif
