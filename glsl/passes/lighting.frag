// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/picture.glsl"

layout(location = 0) out vec4 outRadiance;

void main() {
    Surface surface;
    bool isSurface = readPixel(ivec2(gl_FragCoord.xy), surface);
#ifndef POLYLUME_SHADES_ALL
    if (!isSurface) discard;
#endif
    outRadiance = vec4(shadeSurface(surface), 1.0);
#ifdef POLYLUME_SHADES_ALL
    if (!isSurface) discard;
#endif
}
