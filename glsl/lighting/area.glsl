// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/flat.glsl"
#include "lighting/light.glsl"
#include "lighting/lobes.glsl"
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
    do {
        vec2 factors = parallelogramFactors(parallelogram, position, scaled);
        addLight(factors, parallelograms[parallelogram].radiance.rgb, sum);
    } while (++parallelogram < lighting.lightCount.x);
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
    uint triangle = 0u;
    do {
        addLight(triangleFactors(triangle, position, scaled), polygons[triangle].radiance.rgb, sum);
    } while (++triangle < lighting.lightCount.w);
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
    uint polygon = lighting.lightCount.w;
    do {
        addLight(polygonFactors(polygon, position, scaled), polygons[polygon].radiance.rgb, sum);
    } while (++polygon < lighting.lightCount.y);
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
    uint texturedParallelogram = lighting.lightCount.x;
    do {
        ParallelogramData light = parallelograms[texturedParallelogram];
        LightColors colors = texturedParallelogramColors(light, position, scaled);
        sum.diffuse += light.radiance.rgb * colors.diffuse;
        sum.specular += light.radiance.rgb * colors.specular;
    } while (++texturedParallelogram < lighting.lightCount.x + lighting.texturedLightCount.x);
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
    uint textured = 0u;
    do {
        uint index = lighting.lightCount.y + textured;
        LightColors colors = texturedPolygonColors(index, lightTextures[textured], position, scaled);
        sum.diffuse += polygons[index].radiance.rgb * colors.diffuse;
        sum.specular += polygons[index].radiance.rgb * colors.specular;
    } while (++textured < lighting.texturedLightCount.y);
#endif
#ifdef POLYLUME_DISK_LIGHTS
    uint disk = 0u;
    do {
        addLight(diskFactors(disk, position, lobes), ellipses[disk].radiance.rgb, sum);
    } while (++disk < lighting.roundLightCount.w);
#endif
#ifdef POLYLUME_ELLIPSE_LIGHTS
    uint ellipse = lighting.roundLightCount.w;
    do {
        addLight(ellipseFactors(ellipse, position, lobes), ellipses[ellipse].radiance.rgb, sum);
    } while (++ellipse < lighting.roundLightCount.x);
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
    uint sphere = 0u;
    do {
        addLight(sphereFactors(sphere, position, lobes), spheres[sphere].radiance.rgb, sum);
    } while (++sphere < lighting.roundLightCount.y);
#endif
#ifdef POLYLUME_TUBE_LIGHTS
    uint tube = 0u;
    do {
        addLight(tubeFactors(tube, position, lobes), tubes[tube].radiance.rgb, sum);
    } while (++tube < lighting.roundLightCount.z);
#endif
    reflection.diffuse += lobes.diffuseAlbedo * sum.diffuse;
    reflection.specular += lobes.reflectance * sum.specular;
}
