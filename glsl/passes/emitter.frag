// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "shared/emitter_data.h"
#include "shared/light_data.h"
#include "surface/gbuffer_write.glsl"

in vec3 positionWorld;

/// Where `point` of the light's plane lies along its rectangle's two edges.
vec2 planeCoordinates(vec3 point) {
    vec3 offset = point - emitter.corner.xyz;
    return vec2(dot(offset, emitter.edgeX.xyz), dot(offset, emitter.edgeY.xyz));
}

/// Even-odd rule: how often a ray from the point crosses the contours.
bool isInsideOutline(vec2 point) {
    bool inside = false;
    vec2 from = vec2(0.0);
    for (uint i = emitter.vertices.x; i < emitter.vertices.x + emitter.vertices.y; ++i) {
        vec2 to = planeCoordinates(polygonVertices[i].xyz);
        bool isEdge = polygonVertices[i].w < 0.5;
        bool crosses = isEdge && (from.y > point.y) != (to.y > point.y);
        float x = from.x + (point.y - from.y) * (to.x - from.x) / (to.y - from.y);
        inside = inside != (crosses && point.x < x);
        from = to;
    }
    return inside;
}

void main() {
    if (emitter.radiance.w < 0.5 && !gl_FrontFacing) discard;
    if (emitter.vertices.y > 0u && !isInsideOutline(planeCoordinates(positionWorld))) discard;
    Surface surface;
    surface.normalWorld = gl_FrontFacing ? emitter.normal.xyz : -emitter.normal.xyz;
    surface.diffuseAlbedo = vec3(0.0);
    surface.roughness = 1.0;
    surface.f0 = vec3(0.0);
    surface.f90 = 0.0;
    surface.emission = emitter.radiance.rgb;
    surface.occlusion = 1.0;
    surface.sheenColor = vec3(0.0);
    surface.sheenRoughness = 0.0;
    writeGBuffer(surface);
}
