// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "surface/octahedral.glsl"
#include "surface/surface.glsl"

// The attachments in the order of kGBufferAttachments (lighting/gbuffer_layout.hpp).
layout(location = 0) out vec2 outNormal;
layout(location = 1) out vec4 outDiffuseRoughness;
layout(location = 2) out vec4 outSpecular;
layout(location = 3) out vec4 outEmission;
#ifdef POLYLUME_SHEEN
layout(location = 4) out vec4 outSheen;
#endif

void writeGBuffer(Surface surface) {
    outNormal = octahedralEncode(surface.normalWorld);
    outDiffuseRoughness = vec4(surface.diffuseAlbedo, surface.roughness);
    outSpecular = vec4(surface.f0, surface.f90);
    outEmission = vec4(surface.emission, surface.occlusion);
#ifdef POLYLUME_SHEEN
    outSheen = vec4(surface.sheenColor, surface.sheenRoughness);
#endif
}
