// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/picture.glsl"

layout(location = 0) out vec4 outRadiance;

void main() {
    Surface surface;
    if (!readPixel(ivec2(gl_FragCoord.xy), surface)) discard;
    outRadiance = vec4(shadeSurface(surface), 1.0);
}
