// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/convex.glsl"
#include "ltc/footprint.glsl"
#include "ltc/moments.glsl"

// ltc/parallelogram.glsl with all that a textured light wants to know: beside the form factor, where the light comes from.

/// What a lobe sees of a light, in the space after its M^-1.
struct LtcSight {
    float factor;    ///< The form factor; see ltcCosineFactor() and ltcLobeFactor() of ltc/parallelogram.glsl.
    vec3 direction;  ///< The mean one.
    LtcFrame frame;
};

/// A parallelogram's edges before any clip, in one space.
struct LtcParallelogramEdges {
    vec3 corner0;
    vec3 corner1;
    vec3 corner2;
    vec3 corner3;
    LtcFrame frame;  ///< Its products keep all digits.
};

LtcFrame ltcFrame(vec3 corner, vec3 edgeX, vec3 edgeY) {
    return LtcFrame(corner, edgeX, edgeY, cross(corner, edgeX), cross(corner, edgeY), cross(edgeX, edgeY));
}

/// `p` as ltcClipParallelogram() takes it.
LtcParallelogramEdges ltcParallelogramEdges(vec3 p, vec3 edgeX, vec3 edgeY) {
    vec3 corner0 = ltcSnapToHorizon(p);
    return LtcParallelogramEdges(corner0, ltcSnapToHorizon(p + edgeX), ltcSnapToHorizon(p + edgeX + edgeY),
                                 ltcSnapToHorizon(p + edgeY), ltcFrame(corner0, edgeX, edgeY));
}

/// The same after M^-1.
LtcParallelogramEdges ltcTransform(LtcLobe lobe, LtcParallelogramEdges edges) {
    vec3 corner0 = ltcTransform(lobe, edges.corner0);
    LtcFrame frame =
        ltcFrame(corner0, ltcTransformVector(lobe, edges.frame.edgeX), ltcTransformVector(lobe, edges.frame.edgeY));
    return LtcParallelogramEdges(corner0, ltcTransform(lobe, edges.corner1), ltcTransform(lobe, edges.corner2),
                                 ltcTransform(lobe, edges.corner3), frame);
}

/// ltcClipOutlineEdge() with moments; `crossZ` is the z of a x edge.
void ltcSeeOutlineEdge(int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcSurfaceClip clip,
                       inout LtcMoments moments) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    ltcAddMoments(clipped.first, clipped.last, clipped.share * crossZ, moments);
    ltcNoteCrossing(clipped, clip.crossings);
    clip.share[i] = clipped.share;
    clip.leaves[i] = clipped.leaves;
    clip.enters[i] = clipped.enters;
}

/// What the cosine sees; `clip` is what the surface leaves, for ltcSee().
LtcSight ltcSeeCosine(LtcParallelogramEdges edges, out LtcSurfaceClip clip) {
    LtcFrame frame = edges.frame;
    clip = ltcBeginSurfaceClip();
    LtcMoments moments = ltcNoMoments();
    ltcSeeOutlineEdge(0, edges.corner0, edges.corner1, frame.edgeX, frame.cornerX.z, clip, moments);
    ltcSeeOutlineEdge(1, edges.corner1, edges.corner2, frame.edgeY, frame.cornerY.z + frame.normal.z, clip, moments);
    ltcSeeOutlineEdge(2, edges.corner2, edges.corner3, -frame.edgeX, frame.normal.z - frame.cornerX.z, clip, moments);
    ltcSeeOutlineEdge(3, edges.corner3, edges.corner0, -frame.edgeY, -frame.cornerY.z, clip, moments);
    vec2 leaving = clip.crossings.leaving;
    vec2 entering = clip.crossings.entering;
    clip.closingTurn = sign(leaving.x * entering.y - leaving.y * entering.x);
    ltcAddHorizonMoments(leaving, entering, moments);
    return LtcSight(ltcFactor(moments.sum), ltcMeanDirection(moments), frame);
}

/// ltcAddLobeEdge() with moments; `crossZ` is the z of a x edge.
void ltcSeeLobeEdge(LtcSurfaceClip clip, int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcLobeSum sum,
                    inout LtcMoments moments) {
    float share = clip.share[i];
    vec3 first = clip.enters[i] ? sum.entering : a;
    vec3 last = clip.leaves[i] ? sum.leaving : b;
    bool isKept = share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    ltcAddMoments(clipped.first, clipped.last, clipped.share * (share * crossZ), moments);
    ltcNoteCrossing(clipped, sum.horizon);
}

/// What a lobe sees.
LtcSight ltcSee(LtcParallelogramEdges outline, LtcSurfaceClip clip, LtcLobe lobe) {
    LtcParallelogramEdges edges = ltcTransform(lobe, outline);
    LtcFrame frame = edges.frame;
    LtcLobeSum sum = ltcBeginLobeSum(clip, lobe);
    LtcMoments moments = ltcNoMoments();
    ltcSeeLobeEdge(clip, 0, edges.corner0, edges.corner1, frame.edgeX, frame.cornerX.z, sum, moments);
    ltcSeeLobeEdge(clip, 1, edges.corner1, edges.corner2, frame.edgeY, frame.cornerY.z + frame.normal.z, sum, moments);
    ltcSeeLobeEdge(clip, 2, edges.corner2, edges.corner3, -frame.edgeX, frame.normal.z - frame.cornerX.z, sum, moments);
    ltcSeeLobeEdge(clip, 3, edges.corner3, edges.corner0, -frame.edgeY, -frame.cornerY.z, sum, moments);

    vec3 leaving = sum.leaving;
    vec3 entering = sum.entering;
    LtcClippedEdge closing = ltcClipEdge(leaving, entering, entering - leaving, leaving.z, entering.z);
    ltcAddSurfaceMoments(lobe, closing.first, closing.last, clip.closingTurn, moments);
    ltcNoteCrossing(closing, sum.horizon);
    ltcAddHorizonMoments(sum.horizon.leaving, sum.horizon.entering, moments);
    return LtcSight(ltcFactor(moments.sum) * lobe.weight, ltcMeanDirection(moments), frame);
}
