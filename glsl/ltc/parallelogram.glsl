// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// A parallelogram against the cosine and against any number of lobes, without branches. The clip at the surface is done
// once for all of them. An edge is a start, a vector and the range of its parameter that the clips leave, so a cross
// product is that of the whole edge times the range.

/// Where a convex outline leaves the half-space z >= 0 and where it comes back, along z = 0. Where it never does, two equal
/// directions, between which a closing edge has no length.
struct LtcCrossings {
    vec2 leaving;
    vec2 entering;
};

/// A parallelogram in the shading frame, relative to the shaded point, and what the surface leaves of it.
struct LtcParallelogram {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 corner3;
    vec3 edgeX;  ///< As given: products of theirs keep all digits.
    vec3 edgeY;
    vec4 share;     ///< Of each edge's length above the surface,
    bvec4 leaves;   ///< whether it ends
    bvec4 enters;   ///< or begins at the surface.
    LtcCrossings surface;
    float closingTurn;  ///< 1 where the outline closes counter-clockwise along the surface, -1 clockwise, 0 not at all.
    float cosineSum;
};

void ltcNoteCrossing(LtcClippedEdge clipped, inout LtcCrossings crossings) {
    crossings.leaving = clipped.leaves ? clipped.last.xy : crossings.leaving;
    crossings.entering = clipped.enters ? clipped.first.xy : crossings.entering;
}

LtcCrossings ltcNoCrossings() { return LtcCrossings(vec2(1.0, 0.0), vec2(1.0, 0.0)); }

/// Clips edge `i` from `a` to `b` = a + edge at the surface; `crossZ` is the z of a x edge.
void ltcClipOutlineEdge(int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcParallelogram outline) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    outline.cosineSum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, outline.surface);
    outline.share[i] = clipped.share;
    outline.leaves[i] = clipped.leaves;
    outline.enters[i] = clipped.enters;
}

/// The parallelogram with the corners `p`, `p + edgeX`, `p + edgeX + edgeY`, `p + edgeY`, in the shading frame and
/// relative to the shaded point, clipped at the surface.
LtcParallelogram ltcClipParallelogram(vec3 p, vec3 edgeX, vec3 edgeY) {
    LtcParallelogram outline;
    outline.corner0 = ltcSnapToHorizon(p);
    outline.corner1 = ltcSnapToHorizon(p + edgeX);
    outline.corner2 = ltcSnapToHorizon(p + edgeX + edgeY);
    outline.corner3 = ltcSnapToHorizon(p + edgeY);
    outline.edgeX = edgeX;
    outline.edgeY = edgeY;
    outline.surface = ltcNoCrossings();
    outline.cosineSum = 0.0;
    float crossX = ltcCrossZ(outline.corner0, edgeX);
    float crossY = ltcCrossZ(outline.corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);
    ltcClipOutlineEdge(0, outline.corner0, outline.corner1, edgeX, crossX, outline);
    ltcClipOutlineEdge(1, outline.corner1, outline.corner2, edgeY, crossY + crossXY, outline);
    ltcClipOutlineEdge(2, outline.corner2, outline.corner3, -edgeX, crossXY - crossX, outline);
    ltcClipOutlineEdge(3, outline.corner3, outline.corner0, -edgeY, -crossY, outline);
    // The clipped outline closes along the surface.
    vec3 leaving = vec3(outline.surface.leaving, 0.0);
    vec3 entering = vec3(outline.surface.entering, 0.0);
    outline.closingTurn = sign(ltcCrossZ(leaving, entering));
    outline.cosineSum += outline.closingTurn * ltcAngle(leaving, entering);
    return outline;
}

/// The form factor for the clamped cosine, 0 to 1 where the corners turn counter-clockwise seen from the side that the
/// point is on, else negative.
float ltcCosineFactor(LtcParallelogram outline) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * outline.cosineSum;
}

struct LtcLobeSum {
    float sum;
    LtcCrossings horizon;
};

/// Clips a stretch of the outline after M^-1, from `a` to `b` = a + edge, to z >= 0 and adds its integral; `crossZ` is the
/// z of a x edge, `zA` and `zB` are the heights of its ends.
void ltcAddLobeStretch(vec3 a, vec3 b, vec3 edge, float crossZ, float zA, float zB, inout LtcLobeSum sum) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, zA, zB);
    sum.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, sum.horizon);
}

/// Adds what the surface has left of edge `i`, which M^-1 takes from `a` to `b`; `leaving` and `entering` are where it
/// takes the outline's crossings.
void ltcAddLobeEdge(LtcParallelogram outline, int i, vec3 a, vec3 b, vec3 edge, float crossZ, vec3 leaving,
                    vec3 entering, inout LtcLobeSum sum) {
    float share = outline.share[i];
    vec3 first = outline.enters[i] ? entering : a;
    vec3 last = outline.leaves[i] ? leaving : b;
    // An edge below the surface must not count as crossing the lobe's horizon either.
    bool isKept = share > 0.0;
    ltcAddLobeStretch(first, last, share * edge, share * crossZ, isKept ? first.z : 0.0, isKept ? last.z : 0.0, sum);
}

/// The form factor for a lobe, as a share of the lobe above the surface and times the lobe's share; signed as
/// ltcCosineFactor().
float ltcLobeFactor(LtcParallelogram outline, LtcLobe lobe) {
    vec3 edgeX = vec3(lobe.m11 * outline.edgeX.x + lobe.m13 * outline.edgeX.z, outline.edgeX.y,
                      lobe.m31 * outline.edgeX.x + lobe.m33 * outline.edgeX.z);
    vec3 edgeY = vec3(lobe.m11 * outline.edgeY.x + lobe.m13 * outline.edgeY.z, outline.edgeY.y,
                      lobe.m31 * outline.edgeY.x + lobe.m33 * outline.edgeY.z);
    vec3 corner0 = ltcTransform(lobe, outline.corner0);
    vec3 corner1 = ltcTransform(lobe, outline.corner1);
    vec3 corner2 = ltcTransform(lobe, outline.corner2);
    vec3 corner3 = ltcTransform(lobe, outline.corner3);
    vec3 leaving = ltcTransformHorizontal(lobe, outline.surface.leaving);
    vec3 entering = ltcTransformHorizontal(lobe, outline.surface.entering);
    float crossX = ltcCrossZ(corner0, edgeX);
    float crossY = ltcCrossZ(corner0, edgeY);
    float crossXY = ltcCrossZ(edgeX, edgeY);

    LtcLobeSum sum = LtcLobeSum(0.0, ltcNoCrossings());
    ltcAddLobeEdge(outline, 0, corner0, corner1, edgeX, crossX, leaving, entering, sum);
    ltcAddLobeEdge(outline, 1, corner1, corner2, edgeY, crossY + crossXY, leaving, entering, sum);
    ltcAddLobeEdge(outline, 2, corner2, corner3, -edgeX, crossXY - crossX, leaving, entering, sum);
    ltcAddLobeEdge(outline, 3, corner3, corner0, -edgeY, -crossY, leaving, entering, sum);
    // The surface's closing edge lies in a plane that is known. A smooth lobe at a grazing view makes it all but opposite
    // directions, of which no cross product would tell the plane.
    LtcClippedEdge closing = ltcClipEdge(leaving, entering, entering - leaving, leaving.z, entering.z);
    sum.sum += outline.closingTurn * lobe.surfaceZ * ltcAngle(closing.first, closing.last);
    ltcNoteCrossing(closing, sum.horizon);
    // What M^-1 has pushed below its own horizon closes along that.
    vec3 horizonLeaving = vec3(sum.horizon.leaving, 0.0);
    vec3 horizonEntering = vec3(sum.horizon.entering, 0.0);
    sum.sum += sign(ltcCrossZ(horizonLeaving, horizonEntering)) * ltcAngle(horizonLeaving, horizonEntering);

    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * sum.sum * lobe.weight;
}
