// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "shared/emitter_data.h"

out vec3 positionWorld;
out vec2 share;  // Of the two edges.

/// The bounding rectangle of an area light as a strip of two triangles.
void main() {
    share = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    positionWorld = emitter.corner.xyz + share.x * emitter.edgeX.xyz + share.y * emitter.edgeY.xyz;
    gl_Position = camera.clipFromWorld * vec4(positionWorld, 1.0);
}
