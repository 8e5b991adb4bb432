// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_texture_data.h"

layout(location = kBakeTargetLocation) uniform ivec2 target;  ///< Layer and level.

layout(location = 0) out vec4 outFactor;

/// Takes the coverage out of a level in place. Texels that the light does not reach get the next coarser level's colour,
/// which is finished, so that filters at the light's edge find nothing dark.
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    vec4 own = texelFetch(lightImages, ivec3(texel, target.x), target.y);
    vec2 place = gl_FragCoord.xy / vec2(textureSize(lightImages, target.y).xy);
    vec3 coarser = textureLod(lightImages, vec3(place, float(target.x)), float(target.y + 1)).rgb;
    outFactor = vec4(own.a > 0.0 ? own.rgb / own.a : coarser, 1.0);
}
