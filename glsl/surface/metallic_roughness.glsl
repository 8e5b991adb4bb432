// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "surface/surface.glsl"

/// A glTF metallic-roughness surface of linear base colour that emits nothing. `normalWorld` and `viewWorld` (to the viewer)
/// need not be unit.
Surface metallicRoughnessSurface(vec3 positionWorld, vec3 normalWorld, vec3 viewWorld, vec3 baseColor, float metallic,
                                 float roughness) {
    Surface surface;
    surface.positionWorld = positionWorld;
    surface.normalWorld = normalWorld;
    surface.viewWorld = viewWorld;
    surface.diffuseAlbedo = (1.0 - metallic) * baseColor;
    surface.roughness = roughness;
    surface.f0 = mix(vec3(0.04), baseColor, metallic);
    surface.f90 = 1.0;
    surface.emission = vec3(0.0);
    surface.occlusion = 1.0;
    surface.sheenColor = vec3(0.0);
    surface.sheenRoughness = 0.0;
    return surface;
}
