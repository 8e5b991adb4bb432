// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light.glsl"
#include "lighting/lobes.glsl"
#include "lighting/read_lights.glsl"
#include "ltc/parallelogram.glsl"
#ifdef POLYLUME_LIGHT_LISTS
#include "ltc/parallelogram_above.glsl"
#include "ltc/slender_tube.glsl"
#endif
// Includes are resolved before conditions are: what both sides need comes first.
#if defined(POLYLUME_POLYGON_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#include "ltc/polygon.glsl"
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
#include "ltc/triangle.glsl"
#endif

// Parallelograms, triangles and other polygons. `factors` are those of the diffuse and of the specular reflection, as
// light counts them; rounding leaves them up to a millionth below 0. A `lobeFactor` is that of one lobe.

/// Form factors know no lengths: a frame may be scaled. flatLobes() makes it so small that products of four lengths do not
/// overflow.
SurfaceLobes flatLobes(SurfaceLobes surface) {
    surface.frameFromWorld *= lighting.lobeWeight.w;
    return surface;
}

/// Parallelogram light `index` as the point sees it, and how it counts: 1 from the side that emits, -1 from the back of
/// one that emits from both, else 0.
LtcParallelogram clippedParallelogram(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    ParallelogramData light = parallelogramLight(index);
    vec3 corner = light.corner.xyz - positionWorld;
    side = lightSide(-dot(light.normal.xyz, corner), largestOf(corner), light.corner.w);
    return ltcClipParallelogram(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                frameFromWorld * light.edgeY.xyz);
}

vec2 parallelogramFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcParallelogram outline = clippedParallelogram(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(outline), factors);
}

float parallelogramLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcParallelogram outline = clippedParallelogram(index, positionWorld, frameFromWorld, side);
    return side * ltcLobeFactor(outline, lobe);
}

#ifdef POLYLUME_LIGHT_LISTS
/// parallelogramFactors() of one that the surface and the specular lobes have above their horizons. The other lobes' are
/// not known.
vec2 wholeFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    ParallelogramData light = parallelogramLight(index);
    vec3 corner = light.corner.xyz - positionWorld;
    float side = lightSide(-dot(light.normal.xyz, corner), largestOf(corner), light.corner.w);
    mat3 frame = surface.frameFromWorld;
    LtcParallelogramShape shape =
        ltcParallelogramShape(frame * corner, frame * light.edgeX.xyz, frame * light.edgeY.xyz);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        factors[k] = k < kSpecularLobeCount ? ltcWholeLobeFactor(shape, surface.lobes[k])
                                            : ltcAboveLobeFactor(shape, surface.lobes[k]);
    }
    return side * sumFactors(ltcWholeCosineFactor(shape), factors);
}
#endif

#if defined(POLYLUME_TUBE_LIGHTS) && defined(POLYLUME_LIGHT_LISTS)
/// Tube light `index`, which is slender, as the point sees it.
LtcParallelogram clippedStrip(uint index, vec3 positionWorld, mat3 frameFromWorld) {
    TubeData light = tubeLight(index);
    LtcStrip strip = ltcSlenderTube(light.start.xyz - positionWorld, light.axis.xyz, light.start.w);
    return ltcClipParallelogram(frameFromWorld * strip.corner, frameFromWorld * strip.along,
                                frameFromWorld * strip.across);
}

vec2 stripFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    LtcParallelogram outline = clippedStrip(index, positionWorld, surface.frameFromWorld);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return sumFactors(ltcCosineFactor(outline), factors);
}

float stripLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    return ltcLobeFactor(clippedStrip(index, positionWorld, frameFromWorld), lobe);
}
#endif

#ifdef POLYLUME_TRIANGLE_LIGHTS
/// Polygon light `index`, which has three vertices, as clippedParallelogram().
LtcTriangle clippedTriangle(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    PolygonData light = polygonLight(index);
    uint first = light.vertices.x;
    vec3 vertex = polygonVertex(first).xyz;
    vec3 corner = vertex - positionWorld;
    side = lightSide(-dot(light.plane.xyz, corner), largestOf(corner), light.radiance.w);
    return ltcClipTriangle(frameFromWorld * corner, frameFromWorld * (polygonVertex(first + 1u).xyz - vertex),
                           frameFromWorld * (polygonVertex(first + 2u).xyz - vertex));
}

vec2 triangleFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcTriangle outline = clippedTriangle(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(outline, surface.lobes[k]);
    return side * sumFactors(ltcCosineFactor(outline), factors);
}

float triangleLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcTriangle outline = clippedTriangle(index, positionWorld, frameFromWorld, side);
    return side * ltcLobeFactor(outline, lobe);
}
#endif

#if defined(POLYLUME_POLYGON_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
/// How a point sees a polygon light.
struct PolygonView {
    float side;      ///< As clippedParallelogram() has it.
    float turn;      ///< As ltcCosineFactor() of a polygon
    vec2 toPlane;    ///< and ltcAddImageEdge() want them.
};

/// `offset` leads from the point to the light's first vertex.
PolygonView polygonView(PolygonData light, vec3 offset, mat3 frameFromWorld) {
    float distance = -dot(light.plane.xyz, offset);
    float reach = largestOf(offset) + uintBitsToFloat(light.vertices.z);
    PolygonView view;
    view.side = lightSide(distance, reach, light.radiance.w);
    view.turn = distance > 0.0 ? -1.0 : 1.0;
    view.toPlane = view.turn * (frameFromWorld * light.plane.xyz).xy;
    return view;
}

vec2 polygonFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    PolygonData light = polygonLight(index);
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    PolygonView view = polygonView(light, begin.xyz - positionWorld, surface.frameFromWorld);
    LtcPolygon polygon = ltcBeginPolygon();
    LtcPolygonImage images[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) images[k] = ltcBeginImage();
    do {
        ltcBeginContour(surface.frameFromWorld * (begin.xyz - positionWorld), polygon);
        for (int k = 0; k < kLobeCount; ++k) ltcBeginImageContour(polygon, surface.lobes[k], images[k]);
        uint last = i + uint(begin.w);
        do {
            vec3 vertex = polygonVertex(++i).xyz;
            LtcPolygonEdge edge = ltcAddVertex(surface.frameFromWorld * (vertex - positionWorld), polygon);
            for (int k = 0; k < kLobeCount; ++k) ltcAddImageEdge(edge, surface.lobes[k], view.toPlane, images[k]);
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        factors[k] = ltcLobeFactor(images[k], surface.lobes[k], view.turn, view.toPlane);
    }
    return view.side * sumFactors(ltcCosineFactor(polygon, view.turn), factors);
}

float polygonLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    PolygonData light = polygonLight(index);
    uint i = light.vertices.x;
    uint end = i + light.vertices.y;
    vec4 begin = polygonVertex(i);
    PolygonView view = polygonView(light, begin.xyz - positionWorld, frameFromWorld);
    LtcPolygon polygon = ltcBeginPolygon();
    LtcPolygonImage image = ltcBeginImage();
    do {
        ltcBeginContour(frameFromWorld * (begin.xyz - positionWorld), polygon);
        ltcBeginImageContour(polygon, lobe, image);
        uint last = i + uint(begin.w);
        do {
            vec3 vertex = polygonVertex(++i).xyz;
            LtcPolygonEdge edge = ltcAddVertex(frameFromWorld * (vertex - positionWorld), polygon);
            ltcAddImageEdge(edge, lobe, view.toPlane, image);
        } while (i < last);
        begin = polygonVertex(++i);
    } while (i < end);
    return view.side * ltcLobeFactor(image, lobe, view.turn, view.toPlane);
}
#endif
