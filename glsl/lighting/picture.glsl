// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/shade.glsl"
#include "shared/camera_data.h"
#include "surface/metallic_roughness.glsl"
// The last one, since it may be a host's: what stands there can use all above, and clashes with names above are reported
// as its own.
#include "surface/read_surface.glsl"

#ifdef POLYLUME_HOST_SURFACE
/// `v` of length 1; `fallback` where it has none.
vec3 polylumeUnit(vec3 v, vec3 fallback) {
    float square = dot(v, v);
    vec3 unit = square > 1e-30 ? v * inversesqrt(square) : fallback;
    // One that is unit already keeps its digits.
    return abs(square - 1.0) < 1e-6 ? v : unit;
}

/// What a host handed over, brought into the ranges that the lighting counts on.
void polylumeClean(inout Surface surface) {
    surface.normalWorld = polylumeUnit(surface.normalWorld, vec3(0.0, 1.0, 0.0));
    surface.viewWorld = polylumeUnit(surface.viewWorld, surface.normalWorld);
}
#endif

/// readSurface(), in the form that shadeSurface() wants.
bool readPixel(ivec2 pixel, out Surface surface) {
#ifdef POLYLUME_LIGHT_LISTS
    findLightList(pixel, lighting.texturedLightCount.z);
#endif
    bool isSurface = readSurface(pixel, surface);
#ifdef POLYLUME_HOST_SURFACE
    polylumeClean(surface);
#endif
    return isSurface;
}
