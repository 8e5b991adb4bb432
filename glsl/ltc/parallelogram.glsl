// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A parallelogram against the cosine and against a lobe in one go, without branches: an edge is a start, a vector and
// the range of its parameter that the clips leave, so a cross product is that of the whole edge times the range.

/// Where a convex outline leaves the half-space z >= 0 and where it comes back, along z = 0. Where it never does, two equal
/// directions, between which a closing edge has no length.
struct LtcCrossings {
    vec2 leaving;
    vec2 entering;
};

struct LtcParallelogramSums {
    float cosine;
    float lobe;
    LtcCrossings surface;      ///< Of the outline and the surface, in the shading frame.
    LtcCrossings lobeHorizon;  ///< Of the clipped outline after M^-1 and z = 0.
};

void ltcNoteCrossing(LtcClippedEdge clipped, inout LtcCrossings crossings) {
    crossings.leaving = clipped.leaves ? clipped.last.xy : crossings.leaving;
    crossings.entering = clipped.enters ? clipped.first.xy : crossings.entering;
}

/// Clips a stretch of the outline after M^-1, from `a` to `b` = a + edge, to z >= 0 and adds its integral; `crossZ` is the
/// z of a x edge, `zA` and `zB` are the heights of its ends.
void ltcAddLobeStretch(vec3 a, vec3 b, vec3 edge, float crossZ, float zA, float zB, inout LtcParallelogramSums sums) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, zA, zB);
    sums.lobe += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, sums.lobeHorizon);
}

/// Adds the edge from `a` to `b` of the outline, `qA` and `qB` after M^-1; the vectors between them and the z of the cross
/// products of start and vector come with them.
void ltcAddOutlineEdge(vec3 a, vec3 b, vec3 edge, float crossZ, vec3 qA, vec3 qB, vec3 qEdge, float qCrossZ, LtcLobe lobe,
                       inout LtcParallelogramSums sums) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    sums.cosine += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, sums.surface);

    vec3 qFirst = clipped.enters ? ltcTransformHorizontal(lobe, clipped.first.xy) : qA;
    vec3 qLast = clipped.leaves ? ltcTransformHorizontal(lobe, clipped.last.xy) : qB;
    // An edge below the surface must not count as crossing the lobe's horizon either.
    bool isKept = clipped.share > 0.0;
    ltcAddLobeStretch(qFirst, qLast, clipped.share * qEdge, clipped.share * qCrossZ, isKept ? qFirst.z : 0.0,
                      isKept ? qLast.z : 0.0, sums);
}

/// Form factors of the parallelogram with the corners `p`, `p + edgeX`, `p + edgeX + edgeY`, `p + edgeY`, in the shading
/// frame and relative to the shaded point: x for the clamped cosine, y for the lobe as a share of the lobe above the
/// surface. Both 0 to 1 where the corners turn counter-clockwise seen from the side that the point is on, else negative.
vec2 ltcParallelogram(vec3 p, vec3 edgeX, vec3 edgeY, LtcLobe lobe) {
    // The vectors before anything is snapped: products of theirs keep all digits.
    vec3 qEdgeX = vec3(lobe.m11 * edgeX.x + lobe.m13 * edgeX.z, edgeX.y, lobe.m31 * edgeX.x + lobe.m33 * edgeX.z);
    vec3 qEdgeY = vec3(lobe.m11 * edgeY.x + lobe.m13 * edgeY.z, edgeY.y, lobe.m31 * edgeY.x + lobe.m33 * edgeY.z);
    vec3 p1 = ltcSnapToHorizon(p + edgeX);
    vec3 p2 = ltcSnapToHorizon(p + edgeX + edgeY);
    vec3 p3 = ltcSnapToHorizon(p + edgeY);
    p = ltcSnapToHorizon(p);
    vec3 q = ltcTransform(lobe, p);
    vec3 q1 = ltcTransform(lobe, p1);
    vec3 q2 = ltcTransform(lobe, p2);
    vec3 q3 = ltcTransform(lobe, p3);

    float crossX = ltcCrossZ(p, edgeX);
    float crossY = ltcCrossZ(p, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    float qCrossX = ltcCrossZ(q, qEdgeX);
    float qCrossY = ltcCrossZ(q, qEdgeY);
    float qCrossXY = ltcCrossZ(qEdgeX, qEdgeY);

    LtcCrossings none = LtcCrossings(vec2(1.0, 0.0), vec2(1.0, 0.0));
    LtcParallelogramSums sums = LtcParallelogramSums(0.0, 0.0, none, none);
    ltcAddOutlineEdge(p, p1, edgeX, crossX, q, q1, qEdgeX, qCrossX, lobe, sums);
    ltcAddOutlineEdge(p1, p2, edgeY, crossY + crossXY, q1, q2, qEdgeY, qCrossY + qCrossXY, lobe, sums);
    ltcAddOutlineEdge(p2, p3, -edgeX, crossXY - crossX, q2, q3, -qEdgeX, qCrossXY - qCrossX, lobe, sums);
    ltcAddOutlineEdge(p3, p, -edgeY, -crossY, q3, q, -qEdgeY, -qCrossY, lobe, sums);

    // The clipped outline closes along the surface,
    vec3 leaving = vec3(sums.surface.leaving, 0.0);
    vec3 entering = vec3(sums.surface.entering, 0.0);
    float closingCross = ltcCrossZ(leaving, entering);
    sums.cosine += ltcEdgeIntegral(leaving, entering, closingCross);
    vec3 qLeaving = ltcTransformHorizontal(lobe, leaving.xy);
    vec3 qEntering = ltcTransformHorizontal(lobe, entering.xy);
    ltcAddLobeStretch(qLeaving, qEntering, qEntering - qLeaving, lobe.m11 * closingCross, qLeaving.z, qEntering.z, sums);
    // and what M^-1 has pushed below its own horizon closes along that.
    vec3 lobeLeaving = vec3(sums.lobeHorizon.leaving, 0.0);
    vec3 lobeEntering = vec3(sums.lobeHorizon.entering, 0.0);
    sums.lobe += ltcEdgeIntegral(lobeLeaving, lobeEntering, ltcCrossZ(lobeLeaving, lobeEntering));

    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * vec2(sums.cosine, sums.lobe / lobe.upperShare);
}
