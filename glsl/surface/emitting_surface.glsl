// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "surface/gbuffer_write.glsl"

/// A surface that emits and reflects nothing.
Surface emittingSurface(vec3 radiance, vec3 normalWorld) {
    Surface surface;
    surface.normalWorld = normalWorld;
    surface.diffuseAlbedo = vec3(0.0);
    surface.roughness = 1.0;
    surface.f0 = vec3(0.0);
    surface.f90 = 0.0;
    surface.emission = radiance;
    surface.occlusion = 1.0;
    surface.sheenColor = vec3(0.0);
    surface.sheenRoughness = 0.0;
    return surface;
}
