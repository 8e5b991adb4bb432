// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_texture_data.h"

layout(location = kBakeTargetLocation) uniform ivec2 target;  ///< Layer and level.

layout(location = 0) out vec4 outFactor;

/// The mean of the four texels of the finer level: one read between them.
void main() {
    vec2 size = vec2(textureSize(lightImages, target.y).xy);
    outFactor = textureLod(lightImages, vec3(gl_FragCoord.xy / size, float(target.x)), float(target.y - 1));
}
