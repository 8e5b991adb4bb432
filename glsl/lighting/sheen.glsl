// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/area.glsl"
#include "lighting/light.glsl"
#include "ltc/lobe.glsl"
#include "ltc/parallelogram.glsl"
#include "surface/surface.glsl"
#ifdef POLYLUME_POLYGON_LIGHTS
#include "ltc/polygon.glsl"
#endif

// KHR_materials_sheen: Charlie's lobe over everything else. Its lights are a loop of their own, of no turns for a
// surface without sheen; such a surface does not pay for those that have it.

#ifdef POLYLUME_POLYGON_LIGHTS
/// Form factor of polygon `index` for one lobe, as light counts it.
float polygonLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    PolygonData light = polygons[index];
    float distance = dot(light.plane.xyz, positionWorld) + light.plane.w;
    vec3 normal = frameFromWorld * light.plane.xyz;
    vec3 toPlane = distance > 0.0 ? -normal : normal;
    LtcPolygon polygon = ltcBeginPolygon(toPlane);
    LtcPolygonImage image = ltcBeginImage(toPlane, lobe);
    vec3 reach = vec3(0.0);
    uint last = light.vertices.x + light.vertices.y;
    for (uint i = light.vertices.x; i < last; ++i) {
        vec4 vertex = polygonVertices[i];
        vec3 offset = vertex.xyz - positionWorld;
        reach = max(reach, abs(offset));
        LtcPolygonEdge edge = ltcAddVertex(frameFromWorld * offset, vertex.w < 0.5, polygon);
        ltcAddImageEdge(edge, lobe, image);
    }
    return lightSide(distance, max(reach.x, max(reach.y, reach.z)), light.radiance.w) * ltcLobeFactor(image, lobe);
}
#endif

/// Where the surface has sheen, what it reflects of the area lights with a sheen colour of 1 is added.
/// `albedo` is the directional albedo there, else 0.
void addSheen(Surface surface, mat3 frameFromWorld, inout Reflection reflection, out float albedo) {
    bool hasSheen = max(surface.sheenColor.r, max(surface.sheenColor.g, surface.sheenColor.b)) > 0.0;
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(sheenTable, 0).xy, lighting.sheenReference.xy, surface.sheenRoughness, view);
    albedo = hasSheen ? ltcFetch(sheenTable, place, 1).x : 0.0;
    LtcLobe lobe = ltcDecode(ltcFetch(sheenTable, place, 0), place.axis, 1.0);

    vec3 sum = vec3(0.0);
    uint parallelogramCount = hasSheen ? lighting.lightCount.x : 0u;
    for (uint i = 0u; i < parallelogramCount; ++i) {
        float side;
        LtcParallelogram outline = clippedParallelogram(i, surface.positionWorld, frameFromWorld, side);
        sum += clamp(side * ltcLobeFactor(outline, lobe), 0.0, 1.0) * parallelograms[i].radiance.rgb;
    }
#ifdef POLYLUME_POLYGON_LIGHTS
    uint polygonCount = hasSheen ? lighting.lightCount.y : 0u;
    for (uint i = 0u; i < polygonCount; ++i) {
        float factor = polygonLobeFactor(i, surface.positionWorld, frameFromWorld, lobe);
        sum += clamp(factor, 0.0, 1.0) * polygons[i].radiance.rgb;
    }
#endif
    reflection.sheen += albedo * sum;
}
