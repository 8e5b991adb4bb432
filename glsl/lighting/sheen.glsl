// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/flat.glsl"
#include "lighting/read_lights.glsl"
#include "lighting/round.glsl"
#include "lighting/textured.glsl"
#include "ltc/lobe.glsl"
#include "surface/surface.glsl"

// KHR_materials_sheen: Charlie's lobe over everything else. Its lights are a loop of their own, of no turns for a
// surface without sheen; such a surface does not pay for those that have it.

void addLobe(float factor, vec3 radiance, inout vec3 sum) { sum += clamp(factor, 0.0, 1.0) * radiance; }

/// Where the surface has sheen, what it reflects of the area lights with a sheen colour of 1 is added.
/// `albedo` is the directional albedo there, else 0.
void addSheen(Surface surface, mat3 frameFromWorld, inout Reflection reflection, out float albedo) {
    bool hasSheen = max(surface.sheenColor.r, max(surface.sheenColor.g, surface.sheenColor.b)) > 0.0;
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(sheenTable, 0).xy, lighting.sheenReference.xy, surface.sheenRoughness, view);
    albedo = hasSheen ? ltcFetch(sheenTable, place, 1).x : 0.0;
    LtcLobe lobe = ltcDecode(ltcFetch(sheenTable, place, 0), place.axis, 1.0);

    vec3 position = surface.positionWorld;
    vec3 sum = vec3(0.0);
    if (hasSheen) {
        mat3 scaledFrame = lighting.lobeWeight.w * frameFromWorld;
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
        uint parallelogram = 0u;
        uint parallelogramEnd = lighting.lightCount.x;
        do {
            addLobe(parallelogramLobeFactor(parallelogram, position, scaledFrame, lobe),
                    parallelogramLight(parallelogram).radiance.rgb, sum);
        } while (++parallelogram < parallelogramEnd);
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
        uint triangle = 0u;
        uint triangleEnd = lighting.lightCount.w;
        do {
            addLobe(triangleLobeFactor(triangle, position, scaledFrame, lobe), polygonLight(triangle).radiance.rgb, sum);
        } while (++triangle < triangleEnd);
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
        uint polygon = lighting.lightCount.w;
        uint polygonEnd = lighting.lightCount.y;
        do {
            addLobe(polygonLobeFactor(polygon, position, scaledFrame, lobe), polygonLight(polygon).radiance.rgb, sum);
        } while (++polygon < polygonEnd);
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
        uint texturedParallelogram = lighting.lightCount.x;
        uint texturedParallelogramEnd = lighting.lightCount.x + lighting.texturedLightCount.x;
        do {
            ParallelogramData light = parallelogramLight(texturedParallelogram);
            sum += light.radiance.rgb * texturedParallelogramLobeColor(light, position, scaledFrame, lobe);
        } while (++texturedParallelogram < texturedParallelogramEnd);
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
        uint textured = 0u;
        uint texturedEnd = lighting.texturedLightCount.y;
        do {
            uint index = lighting.lightCount.y + textured;
            sum += polygonLight(index).radiance.rgb * texturedPolygonLobeColor(index, lightTexture(textured), position,
                                                                           scaledFrame, lobe, kDiffuseVariance);
        } while (++textured < texturedEnd);
#endif
#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)
        uint ellipse = 0u;
        uint ellipseEnd = lighting.roundLightCount.x;
        do {
            addLobe(ellipseLobeFactor(ellipse, position, frameFromWorld, lobe), ellipseLight(ellipse).radiance.rgb, sum);
        } while (++ellipse < ellipseEnd);
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
        uint sphere = 0u;
        uint sphereEnd = lighting.roundLightCount.y;
        do {
            addLobe(sphereLobeFactor(sphere, position, frameFromWorld, lobe), sphereLight(sphere).radiance.rgb, sum);
        } while (++sphere < sphereEnd);
#endif
#ifdef POLYLUME_TUBE_LIGHTS
        uint tube = 0u;
        uint tubeEnd = lighting.roundLightCount.z;
        do {
            addLobe(tubeLobeFactor(tube, position, frameFromWorld, lobe), tubeLight(tube).radiance.rgb, sum);
        } while (++tube < tubeEnd);
#endif
    }
    reflection.sheen += albedo * sum;
}
