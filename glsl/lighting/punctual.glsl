// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light.glsl"
#include "surface/surface.glsl"

// Lights without extent, by GGX itself: height-correlated Smith (Heitz 2014, eq. 99) and Schlick's Fresnel (1994).

/// f cos(theta_l) of the specular lobe without Fresnel.
float ggxSpecular(float alpha, vec3 normal, vec3 halfway, float cosView, float cosLight) {
    float a2 = alpha * alpha;
    // The sine from the cross product: 1 - cos^2 has no digits left where a smooth lobe has its peak.
    vec3 sine = cross(normal, halfway);
    float cosine = dot(normal, halfway);
    // At least a2 for a unit vector; light from straight behind has no half vector.
    float base = max(cosine * cosine * a2 + dot(sine, sine), a2);
    float distribution = a2 / (3.14159265 * base * base);
    float lambdaView = cosLight * sqrt(cosView * cosView * (1.0 - a2) + a2);
    float lambdaLight = cosView * sqrt(cosLight * cosLight * (1.0 - a2) + a2);
    return distribution * cosLight * 0.5 / (lambdaView + lambdaLight);
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

/// Adds one light's diffuse irradiance over pi and its reflected specular radiance.
void addPunctual(PunctualData light, Surface surface, inout vec3 diffuse, inout vec3 specular) {
    vec3 toLight;
    vec3 illuminance = punctualIlluminance(light, surface.positionWorld, toLight);
    float cosView = clamp(dot(surface.normalWorld, surface.viewWorld), 1e-4, 1.0);
    float cosLight = max(dot(surface.normalWorld, toLight), 0.0);
    vec3 sum = toLight + surface.viewWorld;
    vec3 halfway = sum * inversesqrt(max(dot(sum, sum), 1e-12));
    float cosViewHalf = clamp(dot(surface.viewWorld, halfway), 0.0, 1.0);
    // The floor of the table's own GGX (tables/README.md).
    float alpha = max(surface.roughness * surface.roughness, 1e-4);
    float lobe = cosLight > 0.0 ? ggxSpecular(alpha, surface.normalWorld, halfway, cosView, cosLight) : 0.0;
    float weight = pow(1.0 - cosViewHalf, 5.0);
    diffuse += illuminance * (cosLight * 0.318309886);
    specular += illuminance * lobe * mix(surface.f0, vec3(surface.f90), weight);
}
