// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// What every pass over the picture costs: a pixel is written.

layout(location = 0) out vec4 outColor;

void main() { outColor = vec4(1.0); }
