// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "surface/gbuffer_write.glsl"
#include "surface/material.glsl"

void main() {
    vec4 baseColor = materialBaseColor();
#ifdef POLYLUME_ALPHA_MASK
    if (baseColor.a < material.alphaCutoff) discard;
#endif
    writeGBuffer(materialSurface(baseColor));
}
