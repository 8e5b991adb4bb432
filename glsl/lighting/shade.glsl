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
#ifdef POLYLUME_PUNCTUAL_LIGHTS
#include "lighting/punctual.glsl"
#endif

/// Form factors of parallelogram `index` for the cosine and the lobe, as light counts them: of the side that emits, or of
/// both. Rounding leaves them up to a millionth below 0.
vec2 parallelogramFactors(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    ParallelogramData light = parallelograms[index];
    vec3 corner = light.corner.xyz - positionWorld;
    float side = lightSide(-dot(light.normal.xyz, corner), max(abs(corner.x), max(abs(corner.y), abs(corner.z))),
                           light.corner.w);
    vec2 factors = ltcParallelogram(frameFromWorld * corner, frameFromWorld * light.edgeX.xyz,
                                    frameFromWorld * light.edgeY.xyz, lobe);
    return side * factors;
}

#ifdef POLYLUME_POLYGON_LIGHTS
/// The same for polygon `index`.
vec2 polygonFactors(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    PolygonData light = polygons[index];
    float distance = dot(light.plane.xyz, positionWorld) + light.plane.w;
    vec3 normal = frameFromWorld * light.plane.xyz;
    LtcPolygon polygon = ltcBeginPolygon(distance > 0.0 ? -normal : normal, lobe);
    vec3 reach = vec3(0.0);
    uint last = light.vertices.x + light.vertices.y;
    for (uint i = light.vertices.x; i < last; ++i) {
        vec4 vertex = polygonVertices[i];
        vec3 offset = vertex.xyz - positionWorld;
        reach = max(reach, abs(offset));
        ltcAddVertex(frameFromWorld * offset, vertex.w < 0.5, lobe, polygon);
    }
    float side = lightSide(distance, max(reach.x, max(reach.y, reach.z)), light.radiance.w);
    return side * ltcFormFactors(polygon, lobe);
}
#endif

/// Radiance that leaves the surface to the viewer, in nits.
vec3 shadeSurface(Surface surface) {
    LtcLobe lobe = ltcLookup(tableMatrices, tableAlbedos, surface.roughness,
                             ltcViewCoordinate(surface.normalWorld, surface.viewWorld));
    vec3 reflectance = ltcReflectance(lobe, surface.f0, surface.f90);
    mat3 frameFromWorld = ltcShadingFrame(surface.normalWorld, surface.viewWorld);

    // Irradiance over pi, and the lobe's mean of the lights' radiance.
    vec3 diffuse = vec3(0.0);
    vec3 lobeMean = vec3(0.0);
    for (uint i = 0u; i < lighting.lightCount.x; ++i) {
        vec2 factors = clamp(parallelogramFactors(i, surface.positionWorld, frameFromWorld, lobe), 0.0, 1.0);
        diffuse += factors.x * parallelograms[i].radiance.rgb;
        lobeMean += factors.y * parallelograms[i].radiance.rgb;
    }
#ifdef POLYLUME_POLYGON_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.y; ++i) {
        vec2 factors = clamp(polygonFactors(i, surface.positionWorld, frameFromWorld, lobe), 0.0, 1.0);
        diffuse += factors.x * polygons[i].radiance.rgb;
        lobeMean += factors.y * polygons[i].radiance.rgb;
    }
#endif
    vec3 specular = reflectance * lobeMean;
#ifdef POLYLUME_PUNCTUAL_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.z; ++i) {
        addPunctual(punctuals[i], surface, diffuse, specular);
    }
#endif
    // What the surface reflects before it enters does not scatter inside: nothing gains energy.
    float remaining = 1.0 - max(reflectance.r, max(reflectance.g, reflectance.b));
    vec3 diffuseColor = max(remaining, 0.0) * surface.diffuseAlbedo;
    return lighting.lobeWeight.x * diffuseColor * diffuse + lighting.lobeWeight.y * specular +
           lighting.lobeWeight.z * surface.emission;
}
