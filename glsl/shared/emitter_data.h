// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kEmitterBinding = 4;

/// An area light as the camera sees it: its bounding rectangle, from which the outline is cut.
struct EmitterData {
    vec4 corner;
    vec4 edgeX;
    vec4 edgeY;
    vec4 normal;      ///< Unit, to the emitting side.
    vec4 radiance;    ///< Nits; w: 1 if both sides emit.
    uvec4 vertices;   ///< First and count in polygonVertices; count 0: the whole rectangle.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kEmitterBinding) uniform EmitterBlock { EmitterData emitter; };
#endif
