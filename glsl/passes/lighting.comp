// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/picture.glsl"

// POLYLUME_TARGET_FORMAT is the target's format; with POLYLUME_ADD the radiance is added to what is there.
#ifndef POLYLUME_TARGET_FORMAT
#define POLYLUME_TARGET_FORMAT rgba32f
#endif

layout(local_size_x = 8, local_size_y = 8) in;

#ifdef POLYLUME_ADD
layout(binding = 0, POLYLUME_TARGET_FORMAT) uniform image2D polylumeTarget;
#else
layout(binding = 0, POLYLUME_TARGET_FORMAT) uniform writeonly image2D polylumeTarget;
#endif
uniform ivec2 polylumeSize;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, polylumeSize))) return;
    Surface surface;
    if (!readPixel(pixel, surface)) return;
    vec3 radiance = shadeSurface(surface);
#ifdef POLYLUME_ADD
    vec4 before = imageLoad(polylumeTarget, pixel);
    imageStore(polylumeTarget, pixel, vec4(before.rgb + radiance, before.a));
#else
    imageStore(polylumeTarget, pixel, vec4(radiance, 1.0));
#endif
}
