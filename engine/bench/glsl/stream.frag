// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Four texels of 16 bytes are read and one is written: as a pass reads a G-buffer, with nothing to compute.

layout(binding = 0) uniform sampler2D first;
layout(binding = 1) uniform sampler2D second;
layout(binding = 2) uniform sampler2D third;
layout(binding = 3) uniform sampler2D fourth;
layout(location = 0) out vec4 outColor;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    outColor = texelFetch(first, pixel, 0) + texelFetch(second, pixel, 0) + texelFetch(third, pixel, 0) +
               texelFetch(fourth, pixel, 0);
}
