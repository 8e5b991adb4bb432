// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/lobe.glsl"
#include "ltc/moments.glsl"

// Where the light of a polygon comes from, streamed edge by edge. The form factor comes from ltc/polygon.glsl, and
// LtcMoments::sum from that.

/// Adds what it takes to close an outline along the lobe's horizon at a point where it leaves or comes back: the horizon's
/// arcs add differences of their ends.
void ltcSeeHorizon(LtcClippedEdge clipped, inout LtcMoments moments) {
    vec2 end = clipped.leaves ? clipped.last.xy : clipped.first.xy;
    end *= inversesqrt(max(dot(end, end), 1e-30));
    float turn = clipped.leaves ? -1.0 : (clipped.enters ? 1.0 : 0.0);
    moments.disk += turn * vec2(end.y, -end.x);
}

/// Adds the edge between two vertices in the shading frame, snapped to the horizon. `reference` points along the surface at
/// the light's plane: where the surface clips the outline, it closes by way of that, as all crossings are within 90 degrees
/// of it.
void ltcSeePolygonEdge(vec3 from, vec3 to, vec2 reference, LtcLobe lobe, inout LtcMoments moments) {
    LtcClippedEdge edge = ltcClipEdge(from, to, to - from, from.z, to.z);
    vec3 start = ltcTransform(lobe, from);
    vec3 whole = ltcTransform(lobe, to) - start;
    vec3 crossing = ltcTransformHorizontal(lobe, edge.leaves ? edge.last.xy : edge.first.xy);
    vec3 first = edge.enters ? crossing : start;
    vec3 last = edge.leaves ? crossing : start + whole;
    bool isKept = edge.share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, edge.share * whole, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    ltcAddMoments(clipped.first, clipped.last, (clipped.share * edge.share) * ltcCrossZ(start, whole), moments);
    ltcSeeHorizon(clipped, moments);

    // The closing stretch between the crossing and the reference.
    bool crosses = edge.leaves || edge.enters;
    vec2 onSurface = edge.leaves ? edge.last.xy : edge.first.xy;
    vec2 target = sqrt(dot(onSurface, onSurface)) * reference;
    float turn = crosses ? sign(onSurface.x * target.y - onSurface.y * target.x) : 0.0;
    vec3 aim = ltcTransformHorizontal(lobe, target);
    vec3 closingFirst = edge.leaves ? crossing : aim;
    vec3 closingLast = edge.leaves ? aim : crossing;
    clipped = ltcClipEdge(closingFirst, closingLast, closingLast - closingFirst, crosses ? closingFirst.z : 0.0,
                          crosses ? closingLast.z : 0.0);
    ltcAddSurfaceMoments(lobe, clipped.first, clipped.last, edge.leaves ? turn : -turn, moments);
    ltcSeeHorizon(clipped, moments);
}
