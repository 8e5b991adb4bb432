// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/far.glsl"
#include "lighting/flat.glsl"
#include "lighting/light_range.glsl"
#include "lighting/read_lights.glsl"
#include "lighting/round.glsl"
#include "lighting/textured.glsl"
#include "ltc/lobe.glsl"
#include "surface/surface.glsl"

// KHR_materials_sheen: Charlie's lobe over everything else. Its lights are a loop of their own, of no turns for a
// surface without sheen; such a surface does not pay for those that have it.

void addLobe(float factor, vec3 radiance, inout vec3 sum) { sum += clamp(factor, 0.0, 1.0) * radiance; }

#ifdef POLYLUME_LIGHT_LISTS
void addFarLobe(FarLight light, LtcLobe lobe, inout vec3 sum) { sum += farLobeFactor(light, lobe) * light.incidence; }
#endif

bool hasSheen(Surface surface) {
    return max(surface.sheenColor.r, max(surface.sheenColor.g, surface.sheenColor.b)) > 0.0;
}

/// The lobe, and its directional albedo: 0 where the surface has no sheen.
LtcLobe sheenLobe(Surface surface, out float albedo) {
    float view = ltcViewParameter(surface.normalWorld, surface.viewWorld);
    LtcPlace place =
        ltcPlace(textureSize(sheenTable, 0).xy, lighting.sheenReference.xy, surface.sheenRoughness, view);
    albedo = hasSheen(surface) ? ltcFetch(sheenTable, place, 1).x : 0.0;
    return ltcDecode(ltcFetch(sheenTable, place, 0), place.axis, 1.0);
}

/// Where the surface has sheen, what it reflects of the area lights with a sheen colour of 1 is added.
/// `albedo` is the directional albedo there, else 0.
void addSheen(Surface surface, mat3 frameFromWorld, inout Reflection reflection, out float albedo) {
    LtcLobe lobe = sheenLobe(surface, albedo);

    vec3 position = surface.positionWorld;
    vec3 sum = vec3(0.0);
    if (hasSheen(surface)) {
        mat3 scaledFrame = lighting.lobeWeight.w * frameFromWorld;
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
        POLYLUME_FOR_LIGHTS(parallelogramRange(), i,
                            addLobe(parallelogramLobeFactor(i, position, scaledFrame, lobe), parallelogramLight(i).radiance.rgb,
                                    sum))
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
        POLYLUME_FOR_LIGHTS(triangleRange(), i,
                            addLobe(triangleLobeFactor(i, position, scaledFrame, lobe), polygonLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
        POLYLUME_FOR_LIGHTS(polygonRange(), i,
                            addLobe(polygonLobeFactor(i, position, scaledFrame, lobe), polygonLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
        POLYLUME_FOR_LIGHTS(
            texturedParallelogramRange(), i,
            sum += parallelogramLight(i).radiance.rgb *
                   texturedParallelogramLobeColor(parallelogramLight(i), position, scaledFrame, lobe))
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
        POLYLUME_FOR_LIGHTS(
            texturedPolygonRange(), i,
            sum += polygonLight(i).radiance.rgb *
                   texturedPolygonLobeColor(i, lightTexture(i - lighting.lightCount.y), position, scaledFrame, lobe,
                                            kDiffuseVariance))
#endif
#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)
        POLYLUME_FOR_LIGHTS(everyEllipseRange(), i,
                            addLobe(ellipseLobeFactor(i, position, frameFromWorld, lobe), ellipseLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
        POLYLUME_FOR_LIGHTS(sphereRange(), i,
                            addLobe(sphereLobeFactor(i, position, frameFromWorld, lobe), sphereLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TUBE_LIGHTS
        POLYLUME_FOR_LIGHTS(tubeRange(), i,
                            addLobe(tubeLobeFactor(i, position, frameFromWorld, lobe), tubeLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_LIGHT_LISTS
        POLYLUME_FOR_LIGHTS(wholeRange(), i,
                            addLobe(parallelogramLobeFactor(i, position, scaledFrame, lobe), parallelogramLight(i).radiance.rgb,
                                    sum))
#ifdef POLYLUME_TUBE_LIGHTS
        POLYLUME_FOR_LIGHTS(stripRange(), i,
                            addLobe(stripLobeFactor(i, position, scaledFrame, lobe), tubeLight(i).radiance.rgb, sum))
#endif
        POLYLUME_FOR_LIGHTS(farRange(), i, addFarLobe(farLight(i, position, frameFromWorld), lobe, sum))
#endif
    }
    reflection.sheen += albedo * sum;
}
