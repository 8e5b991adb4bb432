// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/shade.glsl"
#include "surface/material.glsl"

layout(location = 0) out vec4 outRadiance;

/// A transparent surface, over what is there.
void main() {
    vec4 baseColor = materialBaseColor();
    Surface surface = materialSurface(baseColor);
    // In clip space w is constant or the distance along the axis: the ray's direction is the one of its pixel.
    vec4 clip = camera.clipFromWorld * vec4(surface.positionWorld, 1.0);
    vec2 ndc = clip.xy / clip.w;
    surface.viewWorld = -normalize(camera.rayDirection.xyz + ndc.x * camera.rayDirectionX.xyz +
                                   ndc.y * camera.rayDirectionY.xyz);
    outRadiance = vec4(shadeSurface(surface), clamp(baseColor.a, 0.0, 1.0));
}
