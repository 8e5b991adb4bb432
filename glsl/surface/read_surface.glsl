// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "surface/gbuffer_read.glsl"

/// The surface that `pixel` shows; false where it shows none. A host program's own stands in place of this file
/// (AreaLightingOptions::surfaceGlsl).
bool readSurface(ivec2 pixel, out Surface surface) {
    surface = readGBuffer(pixel);
    return texelFetch(gbufferDepth, pixel, 0).x > 0.0;
}
