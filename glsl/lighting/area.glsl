// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/far.glsl"
#include "lighting/flat.glsl"
#include "lighting/light.glsl"
#include "lighting/light_range.glsl"
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

#if defined(POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS) || defined(POLYLUME_TEXTURED_POLYGON_LIGHTS)
void addColors(LightColors factors, vec3 radiance, inout AreaLight sum) {
    sum.diffuse += radiance * factors.diffuse;
    sum.specular += radiance * factors.specular;
}
#endif

#ifdef POLYLUME_LIGHT_LISTS
void addFarLight(FarLight light, SurfaceLobes lobes, inout AreaLight sum) {
    vec2 factors = farFactors(light, lobes);
    sum.diffuse += factors.x * light.incidence;
    sum.specular += factors.y * light.incidence;
}
#endif

/// Adds what the surface reflects of all area lights.
void addAreaLights(Surface surface, SurfaceLobes lobes, inout Reflection reflection) {
    vec3 position = surface.positionWorld;
    AreaLight sum = AreaLight(vec3(0.0), vec3(0.0));
    SurfaceLobes scaled = flatLobes(lobes);
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
    POLYLUME_FOR_LIGHTS(parallelogramRange(), i,
                        addLight(parallelogramFactors(i, position, scaled), parallelogramLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
    POLYLUME_FOR_LIGHTS(triangleRange(), i,
                        addLight(triangleFactors(i, position, scaled), polygonLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
    POLYLUME_FOR_LIGHTS(polygonRange(), i,
                        addLight(polygonFactors(i, position, scaled), polygonLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS
    POLYLUME_FOR_LIGHTS(texturedParallelogramRange(), i,
                        addColors(texturedParallelogramColors(parallelogramLight(i), position, scaled),
                                  parallelogramLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TEXTURED_POLYGON_LIGHTS
    POLYLUME_FOR_LIGHTS(texturedPolygonRange(), i,
                        addColors(texturedPolygonColors(i, lightTexture(i - lighting.lightCount.y), position, scaled),
                                  polygonLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_DISK_LIGHTS
    POLYLUME_FOR_LIGHTS(diskRange(), i,
                        addLight(diskFactors(i, position, lobes), ellipseLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_ELLIPSE_LIGHTS
    POLYLUME_FOR_LIGHTS(ellipseRange(), i,
                        addLight(ellipseFactors(i, position, lobes), ellipseLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_SPHERE_LIGHTS
    POLYLUME_FOR_LIGHTS(sphereRange(), i,
                        addLight(sphereFactors(i, position, lobes), sphereLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_TUBE_LIGHTS
    POLYLUME_FOR_LIGHTS(tubeRange(), i, addLight(tubeFactors(i, position, lobes), tubeLight(i).radiance.rgb, sum))
#endif
#ifdef POLYLUME_LIGHT_LISTS
    POLYLUME_FOR_LIGHTS(wholeRange(), i,
                        addLight(wholeFactors(i, position, scaled), parallelogramLight(i).radiance.rgb, sum))
#ifdef POLYLUME_TUBE_LIGHTS
    POLYLUME_FOR_LIGHTS(stripRange(), i, addLight(stripFactors(i, position, scaled), tubeLight(i).radiance.rgb, sum))
#endif
    POLYLUME_FOR_LIGHTS(farRange(), i, addFarLight(farLight(i, position, lobes.frameFromWorld), lobes, sum))
#endif
    reflection.diffuse += lobes.diffuseAlbedo * sum.diffuse;
    reflection.specular += lobes.reflectance * sum.specular;
}
