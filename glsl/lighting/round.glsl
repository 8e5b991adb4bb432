// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light.glsl"
#include "lighting/lobes.glsl"
#include "lighting/read_lights.glsl"
// Includes are resolved before conditions are: a shader without such lights leaves their functions unused.
#include "ltc/disk.glsl"
#include "ltc/ellipse.glsl"
#include "ltc/sphere.glsl"
#include "ltc/tube.glsl"

// Ellipses, spheres and tubes; names as in lighting/flat.glsl.

#if defined(POLYLUME_DISK_LIGHTS) || defined(POLYLUME_ELLIPSE_LIGHTS)
/// Ellipse light `index` as the point sees it, and whether it does: 1 or 0.
LtcEllipse ellipseOf(uint index, vec3 positionWorld, mat3 frameFromWorld, out float side) {
    EllipseData light = ellipseLight(index);
    vec3 center = light.center.xyz - positionWorld;
    float height = -dot(light.normal.xyz, center);
    side = abs(lightSide(height, largestOf(center), light.center.w));
    // Sizes about 1: products of them stay in range.
    float unit = inversesqrt(dot(center, center) + dot(light.halfAxisX.xyz, light.halfAxisX.xyz) +
                             dot(light.halfAxisY.xyz, light.halfAxisY.xyz));
    vec3 halfAxisX = unit * light.halfAxisX.xyz;
    vec3 halfAxisY = (height > 0.0 ? -unit : unit) * light.halfAxisY.xyz;
    vec3 area = cross(halfAxisX, halfAxisY);
    float volume = sqrt(dot(area, area)) * abs(height) * unit;
    return LtcEllipse(frameFromWorld * (unit * center), frameFromWorld * halfAxisX, frameFromWorld * halfAxisY,
                      volume);
}

vec2 ellipseFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcEllipse ellipse = ellipseOf(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(ellipse, surface.lobes[k]);
    // Edge-on the cone has no digits, or is none.
    return side > 0.5 ? sumFactors(ltcCosineFactor(ellipse), factors) : vec2(0.0);
}

/// The same for the ellipses that are disks, at less cost.
vec2 diskFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    float side;
    LtcEllipse disk = ellipseOf(index, positionWorld, surface.frameFromWorld, side);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) factors[k] = ltcLobeFactor(disk, surface.lobes[k]);
    return side > 0.5 ? sumFactors(ltcDiskCosineFactor(disk), factors) : vec2(0.0);
}

float ellipseLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    float side;
    LtcEllipse ellipse = ellipseOf(index, positionWorld, frameFromWorld, side);
    return side > 0.5 ? ltcLobeFactor(ellipse, lobe) : 0.0;
}
#endif

#ifdef POLYLUME_SPHERE_LIGHTS
vec2 sphereFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    SphereData light = sphereLight(index);
    vec3 center = light.center.xyz - positionWorld;
    LtcEllipse ellipse = ltcEllipseOfSphere(surface.frameFromWorld * center, light.center.w);
    bool isInside = dot(center, center) < light.center.w * light.center.w;
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        LtcLobe lobe = surface.lobes[k];
        factors[k] = isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(ellipse, lobe);
    }
    return sumFactors(isInside ? light.radiance.w : ltcSphereCosineFactor(ellipse), factors);
}

float sphereLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    SphereData light = sphereLight(index);
    vec3 center = light.center.xyz - positionWorld;
    LtcEllipse ellipse = ltcEllipseOfSphere(frameFromWorld * center, light.center.w);
    bool isInside = dot(center, center) < light.center.w * light.center.w;
    return isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(ellipse, lobe);
}
#endif

#ifdef POLYLUME_TUBE_LIGHTS
vec2 tubeFactors(uint index, vec3 positionWorld, SurfaceLobes surface) {
    TubeData light = tubeLight(index);
    LtcTube tube = ltcTube(surface.frameFromWorld * (light.start.xyz - positionWorld),
                           surface.frameFromWorld * light.axis.xyz, light.start.w);
    LtcTubeClip clip = ltcClipTube(tube);
    float factors[kLobeCount];
    for (int k = 0; k < kLobeCount; ++k) {
        LtcLobe lobe = surface.lobes[k];
        factors[k] = tube.isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(tube, clip, lobe);
    }
    return sumFactors(tube.isInside ? light.radiance.w : ltcCosineFactor(tube, clip), factors);
}

float tubeLobeFactor(uint index, vec3 positionWorld, mat3 frameFromWorld, LtcLobe lobe) {
    TubeData light = tubeLight(index);
    LtcTube tube = ltcTube(frameFromWorld * (light.start.xyz - positionWorld), frameFromWorld * light.axis.xyz,
                           light.start.w);
    return tube.isInside ? light.radiance.w * ltcFullFactor(lobe) : ltcLobeFactor(tube, ltcClipTube(tube), lobe);
}
#endif
