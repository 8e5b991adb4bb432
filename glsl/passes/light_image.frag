// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/light_texture_data.h"

layout(binding = kBakeSourceUnit) uniform sampler2D source;
layout(binding = kBakeCoverageUnit) uniform sampler2D coverage;
layout(location = kBakeScaleLocation) uniform vec2 scale;    ///< Of the frame's places to texture coordinates.
layout(location = kBakeOriginLocation) uniform vec2 origin;  ///< Coordinates in `source` of the frame's corner,
layout(location = kBakeAxesLocation) uniform vec4 axes;      ///< and what its edges add to them: xy, zw.
layout(location = kBakeReadsLocation) uniform ivec3 reads;   ///< A texel's, along the edges; z: 1 to read `coverage`.
layout(location = kBakeLargestLocation) uniform float largest;  ///< That the image's format holds.

layout(location = 0) out vec4 outFactor;

/// Level 0 of a light's image: factors of the radiance times coverage, and coverage. Beyond the frame it is repeated
/// mirrored.
void main() {
    vec2 step = 1.0 / (vec2(textureSize(lightImages, 0).xy) * scale);
    vec2 place = abs(mod(gl_FragCoord.xy * step + 1.0, 2.0) - 1.0);
    vec3 sum = vec3(0.0);
    int count = reads.x * reads.y;
    int i = 0;
    do {
        vec2 p = place + step * ((vec2(i % reads.x, i / reads.x) + 0.5) / vec2(reads.xy) - 0.5);
        sum += textureLod(source, origin + p.x * axes.xy + p.y * axes.zw, 0.0).rgb;
    } while (++i < count);
    sum /= float(count);
    // What is no number gives no light.
    sum = mix(vec3(0.0), min(sum, vec3(largest)), greaterThan(sum, vec3(0.0)));
    float covered = 1.0;
    if (reads.z > 0) covered = texelFetch(coverage, ivec2(place / step), 0).r;
    outFactor = vec4(sum * covered, covered);
}
