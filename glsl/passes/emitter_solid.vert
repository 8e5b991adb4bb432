// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/camera_data.h"
#include "shared/emitter_data.h"

out vec4 clip;

/// The box around a ball or tube: six faces of two triangles each, counter-clockwise seen from outside.
void main() {
    int face = gl_VertexID / 6;
    int axis = face >> 1;
    int corner = gl_VertexID % 6;
    // The two triangles of a face share the diagonal from one corner to the other.
    bvec2 isFar = bvec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    bool outward = (face & 1) == 1;
    vec3 share = vec3(0.0);
    share[axis] = outward ? 1.0 : 0.0;
    share[(axis + 1) % 3] = float(outward ? isFar.x : isFar.y);
    share[(axis + 2) % 3] = float(outward ? isFar.y : isFar.x);
    vec3 positionWorld = emitter.corner.xyz + share.x * emitter.edgeX.xyz + share.y * emitter.edgeY.xyz +
                         share.z * emitter.edgeZ.xyz;
    clip = camera.clipFromWorld * vec4(positionWorld, 1.0);
    gl_Position = clip;
}
