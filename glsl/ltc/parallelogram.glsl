// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A parallelogram against the cosine and against a lobe in one go, without branches: an edge is a start, a vector and
// the range of its parameter that the clips leave, so a cross product is that of the whole edge times the range.

/// Where the outline leaves the half-space z >= 0 and where it comes back, as far as seen.
struct LtcCrossings {
    vec3 leaving;
    vec3 entering;
    bool crosses;
};

struct LtcParallelogramSums {
    float cosine;
    float lobe;
    LtcCrossings surface;     ///< Of the outline and the surface, in the shading frame.
    float leavingZ;           ///< z after M^-1 of its two points: the same numbers for the edges that share them.
    float enteringZ;
    LtcCrossings lobeHorizon;  ///< Of the clipped outline after M^-1 and z = 0.
};

/// Clips a stretch from `a` to `a + edge`, given after M^-1, to z >= 0, notes where it crosses and adds its integral.
/// `crossZ` is the z of a x edge, `zA` and `zB` the heights of its ends.
void ltcAddLobeStretch(vec3 a, vec3 edge, float crossZ, float zA, float zB, inout LtcParallelogramSums sums) {
    vec2 range = ltcClipEdge(zA, zB);
    vec3 first = a + range.x * edge;
    vec3 last = a + range.y * edge;
    sums.lobe += ltcEdgeIntegral(first, last, (range.y - range.x) * crossZ);
    bool leaves = zA >= 0.0 && zB < 0.0;
    bool enters = zA < 0.0 && zB >= 0.0;
    sums.lobeHorizon.leaving = leaves ? last : sums.lobeHorizon.leaving;
    sums.lobeHorizon.entering = enters ? first : sums.lobeHorizon.entering;
    sums.lobeHorizon.crosses = sums.lobeHorizon.crosses || leaves;
}

/// Adds the edge from `p` to `p + edge` of the outline: `q`, `qEdge` are the two after M^-1, `crossZ` and `qCrossZ` the z
/// of the cross products of start and edge, `zA`, `zB` the heights of the ends after M^-1.
void ltcAddOutlineEdge(vec3 p, vec3 edge, float crossZ, float pzB, vec3 q, vec3 qEdge, float qCrossZ, float zA, float zB,
                       inout LtcParallelogramSums sums) {
    vec2 range = ltcClipEdge(p.z, pzB);
    float share = range.y - range.x;
    vec3 first = p + range.x * edge;
    vec3 last = p + range.y * edge;
    sums.cosine += ltcEdgeIntegral(first, last, share * crossZ);

    bool leaves = p.z >= 0.0 && pzB < 0.0;
    bool enters = p.z < 0.0 && pzB >= 0.0;
    float zFirst = enters ? zA + range.x * qEdge.z : zA;
    float zLast = leaves ? zA + range.y * qEdge.z : zB;
    sums.surface.leaving = leaves ? last : sums.surface.leaving;
    sums.surface.entering = enters ? first : sums.surface.entering;
    sums.surface.crosses = sums.surface.crosses || leaves;
    sums.leavingZ = leaves ? zLast : sums.leavingZ;
    sums.enteringZ = enters ? zFirst : sums.enteringZ;

    // An edge below the surface must not count as crossing the lobe's horizon either.
    bool below = p.z < 0.0 && pzB < 0.0;
    ltcAddLobeStretch(q + range.x * qEdge, share * qEdge, share * qCrossZ, below ? 0.0 : zFirst, below ? 0.0 : zLast,
                      sums);
}

/// Form factors of the parallelogram with the corners `p`, `p + edgeX`, `p + edgeX + edgeY`, `p + edgeY`, in the shading
/// frame and relative to the shaded point: x for the clamped cosine, y for the lobe as a share of the lobe above the
/// surface. Both 0 to 1 where the corners turn counter-clockwise seen from the side that the point is on, else negative.
vec2 ltcParallelogram(vec3 p, vec3 edgeX, vec3 edgeY, LtcLobe lobe) {
    vec3 q = ltcTransform(lobe, p);
    vec3 qEdgeX = ltcTransform(lobe, edgeX);
    vec3 qEdgeY = ltcTransform(lobe, edgeY);

    float crossX = ltcCrossZ(p, edgeX);
    float crossY = ltcCrossZ(p, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    float qCrossX = ltcCrossZ(q, qEdgeX);
    float qCrossY = ltcCrossZ(q, qEdgeY);
    float qCrossXY = ltcCrossZ(qEdgeX, qEdgeY);

    vec3 p1 = p + edgeX;
    vec3 p2 = p1 + edgeY;
    vec3 p3 = p + edgeY;
    vec3 q1 = q + qEdgeX;
    vec3 q2 = q1 + qEdgeY;
    vec3 q3 = q + qEdgeY;

    // Directions that no crossing ever overwrites give the closing edges no length.
    LtcCrossings none = LtcCrossings(vec3(1.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), false);
    LtcParallelogramSums sums = LtcParallelogramSums(0.0, 0.0, none, 0.0, 0.0, none);
    ltcAddOutlineEdge(p, edgeX, crossX, p1.z, q, qEdgeX, qCrossX, q.z, q1.z, sums);
    ltcAddOutlineEdge(p1, edgeY, crossY + crossXY, p2.z, q1, qEdgeY, qCrossY + qCrossXY, q1.z, q2.z, sums);
    ltcAddOutlineEdge(p2, -edgeX, crossXY - crossX, p3.z, q2, -qEdgeX, qCrossXY - qCrossX, q2.z, q3.z, sums);
    ltcAddOutlineEdge(p3, -edgeY, -crossY, p.z, q3, -qEdgeY, -qCrossY, q3.z, q.z, sums);

    // The clipped outline closes along the surface,
    vec3 leaving = vec3(sums.surface.leaving.xy, 0.0);
    vec3 entering = vec3(sums.surface.entering.xy, 0.0);
    float closingCross = ltcCrossZ(leaving, entering);
    sums.cosine += ltcEdgeIntegral(leaving, entering, closingCross);
    float zLeaving = sums.surface.crosses ? sums.leavingZ : 0.0;
    float zEntering = sums.surface.crosses ? sums.enteringZ : 0.0;
    vec3 qLeaving = vec3(lobe.m11 * leaving.x, leaving.y, zLeaving);
    vec3 qEntering = vec3(lobe.m11 * entering.x, entering.y, zEntering);
    ltcAddLobeStretch(qLeaving, qEntering - qLeaving, lobe.m11 * closingCross, zLeaving, zEntering, sums);
    // and what M^-1 has pushed below its own horizon closes along that.
    vec3 lobeLeaving = vec3(sums.lobeHorizon.leaving.xy, 0.0);
    vec3 lobeEntering = vec3(sums.lobeHorizon.entering.xy, 0.0);
    sums.lobe += ltcEdgeIntegral(lobeLeaving, lobeEntering, ltcCrossZ(lobeLeaving, lobeEntering));

    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * vec2(sums.cosine, sums.lobe / lobe.upperShare);
}
