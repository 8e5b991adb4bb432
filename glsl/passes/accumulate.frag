// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

layout(binding = 0) uniform sampler2D frameRadiance;

layout(location = 0) out vec4 outSum;

/// One jittered frame, added to the others by blending.
void main() { outSum = texelFetch(frameRadiance, ivec2(gl_FragCoord.xy), 0); }
