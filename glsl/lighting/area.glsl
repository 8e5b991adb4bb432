// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/flat.glsl"
#include "lighting/light.glsl"
#include "lighting/lobes.glsl"
#include "lighting/read_lights.glsl"
#include "surface/surface.glsl"
// Left out where there are no such lights: a compiler takes as long for functions that nobody calls. Others that include
// them come later, and under the same conditions.
#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS) || defined(POLYLUME_SPHERE_LIGHTS) || \
    defined(POLYLUME_TUBE_LIGHTS)
#include "lighting/round.glsl"
#endif
#if defined(POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
#include "lighting/textured.glsl"
#endif

/// The lights' radiance times their form factors, for the diffuse and the specular reflection.
struct AreaLight {
    vec3 diffuse;
    vec3 specular;
};

void addLight(vec2 factors, vec3 radiance, inout AreaLight sum) {
    vec2 inRange = clamp(factors, 0.0, 1.0);
    sum.diffuse += inRange.x * radiance;
    sum.specular += inRange.y * radiance;
}

/// Adds what the surface reflects of all area lights.
void addAreaLights(Surface surface, SurfaceLobes lobes, inout Reflection reflection) {
    vec3 position = surface.positionWorld;
    AreaLight sum = AreaLight(vec3(0.0), vec3(0.0));
    SurfaceLobes scaled = flatLobes(lobes);
    // Where there are lights of a kind, the first of them is there. A software rasteriser runs the body of a loop that
    // asks at its beginning once more, only to find that it is over.
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
    uint parallelogram = 0u;
    uint parallelogramEnd = lighting.lightCount.x;
    do {
        vec2 factors = parallelogramFactors(parallelogram, position, scaled);
        addLight(factors, parallelogramLight(parallelogram).radiance.rgb, sum);
    } while (++parallelogram < parallelogramEnd);
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
    uint triangle = 0u;
    uint triangleEnd = lighting.lightCount.w;
    do {
        addLight(triangleFactors(triangle, position, scaled), polygonLight(triangle).radiance.rgb, sum);
    } while (++triangle < triangleEnd);
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
    uint polygon = lighting.lightCount.w;
    uint polygonEnd = lighting.lightCount.y;
    do {
        addLight(polygonFactors(polygon, position, scaled), polygonLight(polygon).radiance.rgb, sum);
    } while (++polygon < polygonEnd);
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
    uint texturedParallelogram = lighting.lightCount.x;
    uint texturedParallelogramEnd = lighting.lightCount.x + lighting.texturedLightCount.x;
    do {
        ParallelogramData light = parallelogramLight(texturedParallelogram);
        LightColors colors = texturedParallelogramColors(light, position, scaled);
        sum.diffuse += light.radiance.rgb * colors.diffuse;
        sum.specular += light.radiance.rgb * colors.specular;
    } while (++texturedParallelogram < texturedParallelogramEnd);
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
    uint textured = 0u;
    uint texturedEnd = lighting.texturedLightCount.y;
    do {
        uint index = lighting.lightCount.y + textured;
        LightColors colors = texturedPolygonColors(index, lightTexture(textured), position, scaled);
        sum.diffuse += polygonLight(index).radiance.rgb * colors.diffuse;
        sum.specular += polygonLight(index).radiance.rgb * colors.specular;
    } while (++textured < texturedEnd);
#endif
#ifdef POLYLUME_DISK_LIGHTS
    uint disk = 0u;
    uint diskEnd = lighting.roundLightCount.w;
    do {
        addLight(diskFactors(disk, position, lobes), ellipseLight(disk).radiance.rgb, sum);
    } while (++disk < diskEnd);
#endif
#ifdef POLYLUME_ELLIPSE_LIGHTS
    uint ellipse = lighting.roundLightCount.w;
    uint ellipseEnd = lighting.roundLightCount.x;
    do {
        addLight(ellipseFactors(ellipse, position, lobes), ellipseLight(ellipse).radiance.rgb, sum);
    } while (++ellipse < ellipseEnd);
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
    uint sphere = 0u;
    uint sphereEnd = lighting.roundLightCount.y;
    do {
        addLight(sphereFactors(sphere, position, lobes), sphereLight(sphere).radiance.rgb, sum);
    } while (++sphere < sphereEnd);
#endif
#ifdef POLYLUME_TUBE_LIGHTS
    uint tube = 0u;
    uint tubeEnd = lighting.roundLightCount.z;
    do {
        addLight(tubeFactors(tube, position, lobes), tubeLight(tube).radiance.rgb, sum);
    } while (++tube < tubeEnd);
#endif
    reflection.diffuse += lobes.diffuseAlbedo * sum.diffuse;
    reflection.specular += lobes.reflectance * sum.specular;
}
