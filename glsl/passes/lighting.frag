// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/shade.glsl"
#include "surface/gbuffer_read.glsl"

layout(location = 0) out vec4 outRadiance;

void main() { outRadiance = vec4(shadeSurface(readGBuffer(ivec2(gl_FragCoord.xy))), 1.0); }
