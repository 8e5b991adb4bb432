// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/angles.glsl"
#include "brdf/beckmann.glsl"
#include "brdf/burley.glsl"
#include "brdf/charlie.glsl"
#include "brdf/ggx.glsl"
#include "brdf/oren_nayar.glsl"
#include "lighting/light.glsl"
#include "surface/surface.glsl"

// Lights without extent, by the BRDFs themselves, with Schlick's Fresnel (1994).

float specularEvaluate(BrdfAngles angles, float roughness) {
#ifdef POLYLUME_SPECULAR_BECKMANN
    return beckmannEvaluate(angles, roughness);
#else
    return ggxEvaluate(angles, roughness);
#endif
}

/// With a base colour of 1.
float diffuseEvaluate(BrdfAngles angles, float roughness) {
#if defined(POLYLUME_DIFFUSE_BURLEY)
    return burleyEvaluate(angles, roughness);
#elif defined(POLYLUME_DIFFUSE_OREN_NAYAR)
    return orenNayarEvaluate(angles, roughness);
#else
    return angles.cosLight * 0.318309886;
#endif
}

/// Illuminance without the cosine, in lux, and the unit direction to the light.
vec3 punctualIlluminance(PunctualData light, vec3 positionWorld, out vec3 toLight) {
    if (light.direction.w > 0.5) {
        toLight = -light.direction.xyz;
        return light.intensity.rgb;
    }
    vec3 offset = light.position.xyz - positionWorld;
    float square = max(dot(offset, offset), 1e-12);
    toLight = offset * inversesqrt(square);
    // KHR_lights_punctual: the window that brings a light with a range to zero there.
    float ratio = square * light.position.w;
    float window = clamp(1.0 - ratio * ratio, 0.0, 1.0);
    float cone = clamp(dot(-toLight, light.direction.xyz) * light.cone.x + light.cone.y, 0.0, 1.0);
    return light.intensity.rgb * (window * cone * cone / square);
}

/// Adds what the surface reflects of one light.
void addPunctual(PunctualData light, Surface surface, inout Reflection reflection) {
    vec3 toLight;
    vec3 illuminance = punctualIlluminance(light, surface.positionWorld, toLight);
    BrdfAngles angles = brdfAngles(surface.normalWorld, surface.viewWorld, toLight);
    illuminance = angles.cosLight > 0.0 ? illuminance : vec3(0.0);
    angles.cosLight = max(angles.cosLight, 1e-7);
    vec3 fresnel = mix(surface.f0, vec3(surface.f90), pow(1.0 - angles.cosViewHalf, 5.0));
    reflection.diffuse += illuminance * diffuseEvaluate(angles, surface.roughness);
    reflection.specular += illuminance * specularEvaluate(angles, surface.roughness) * fresnel;
#ifdef POLYLUME_SHEEN
    reflection.sheen += illuminance * charlieEvaluate(angles, surface.sheenRoughness);
#endif
}
