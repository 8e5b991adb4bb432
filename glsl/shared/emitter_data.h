// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/types.h"
#ifdef __cplusplus
#pragma once
namespace polylume::shared {
#endif

const uint kEmitterBinding = 4;

// What is cut from a flat light's bounding rectangle.
const uint kWholeOutline = 0;
const uint kPolygonOutline = 1;
const uint kEllipseOutline = 2;

// Whose image is on a flat light.
const uint kNoImage = 0;
const uint kParallelogramImage = 1;
const uint kPolygonImage = 2;

/// An area light as the camera sees it: the bounding rectangle of a flat one, from which the outline is cut, or the box
/// around a ball or a tube.
struct EmitterData {
    vec4 corner;
    vec4 edgeX;
    vec4 edgeY;
    vec4 edgeZ;       ///< Of a box; the three turn as x, y and z do.
    vec4 normal;      ///< Of a flat light: unit, to the emitting side.
    vec4 radiance;    ///< Nits; w: 1 if both sides emit.
    uvec4 vertices;   ///< Of a flat light: first, count in polygonVertices; z: which outline; w: whose image.
    vec4 image;       ///< Of a parallelogram: x its layer, yz how many of its texels go along the edges; of a polygon: x
                      ///< its index in lightTextures; w unused.
    vec4 start;       ///< Of a ball or tube: where its axis begins; w: radius.
    vec4 axis;        ///< To the axis's other end; 0 for a ball.
};

#ifdef __cplusplus
}  // namespace polylume::shared
#else
layout(std140, binding = kEmitterBinding) uniform EmitterBlock { EmitterData emitter; };
#endif
