// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_texture_data.h"

layout(location = kBakeTargetLocation) uniform ivec2 target;  ///< Layer and level.

layout(location = 0) out vec4 outFactor;

/// The binomial mean (1 3 3 1 each way) of the finer level around the texel: four reads between its texels. A mean of the
/// four texels alone would show as steps where the level is magnified.
void main() {
    vec2 size = vec2(textureSize(lightImages, target.y).xy);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 offset = vec2(i % 2, i / 2) * 0.75 - 0.375;
        sum += textureLod(lightImages, vec3((gl_FragCoord.xy + offset) / size, float(target.x)), float(target.y - 1));
    }
    outFactor = 0.25 * sum;
}
