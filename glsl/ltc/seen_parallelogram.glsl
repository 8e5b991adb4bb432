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

/// What the cosine sees; `clip` is what the surface leaves, for ltcSee().
LtcSight ltcSeeCosine(LtcParallelogramEdges edges, out LtcSurfaceClip clip) {
    LtcFrame frame = edges.frame;
    clip.crossings = ltcNoCrossings();
    ltcNoteCrossing(edges.corner0, edges.corner1, frame.edgeX, clip.crossings);
    ltcNoteCrossing(edges.corner1, edges.corner2, frame.edgeY, clip.crossings);
    ltcNoteCrossing(edges.corner2, edges.corner3, -frame.edgeX, clip.crossings);
    ltcNoteCrossing(edges.corner3, edges.corner0, -frame.edgeY, clip.crossings);
    clip.closingTurn = ltcClosingTurn(clip.crossings);
    clip.share.x = ltcShareAbove(edges.corner0, edges.corner1);
    clip.share.y = ltcShareAbove(edges.corner1, edges.corner2);
    clip.share.z = ltcShareAbove(edges.corner2, edges.corner3);
    clip.share.w = ltcShareAbove(edges.corner3, edges.corner0);
    LtcCrossings crossings = clip.crossings;
    LtcMoments moments = ltcNoMoments();
    LtcEnds ends = ltcEndsAbove(edges.corner0, edges.corner1, crossings);
    ltcAddMoments(ends.first, ends.last, clip.share.x * frame.cornerX.z, moments);
    ends = ltcEndsAbove(edges.corner1, edges.corner2, crossings);
    ltcAddMoments(ends.first, ends.last, clip.share.y * (frame.cornerY.z + frame.normal.z), moments);
    ends = ltcEndsAbove(edges.corner2, edges.corner3, crossings);
    ltcAddMoments(ends.first, ends.last, clip.share.z * (frame.normal.z - frame.cornerX.z), moments);
    ends = ltcEndsAbove(edges.corner3, edges.corner0, crossings);
    ltcAddMoments(ends.first, ends.last, -clip.share.w * frame.cornerY.z, moments);
    ltcAddHorizonMoments(crossings.leaving, crossings.entering, moments);
    return LtcSight(ltcFactor(moments.sum), ltcMeanDirection(moments), frame);
}

/// Adds the closing edge along the surface.
void ltcAddClosingMoments(LtcClosing closing, LtcLobe lobe, inout LtcMoments moments) {
    moments.sum += lobe.surfaceZ * ltcPlaneAngle(closing.first, closing.last, closing.turn);
    vec2 difference = closing.last * inversesqrt(max(dot(closing.last, closing.last), 1e-30)) -
                      closing.first * inversesqrt(max(dot(closing.first, closing.first), 1e-30));
    // In the image of the surface directions are (z cos, sin, x cos) of its normal's x and z.
    moments.disk += abs(closing.turn * lobe.surfaceZ) * vec2(lobe.surfaceZ * difference.y, -difference.x);
}

/// What a lobe sees.
LtcSight ltcSee(LtcParallelogramEdges edges, LtcSurfaceClip surface, LtcLobe lobe) {
    vec4 heights = vec4(edges.corner0.z, edges.corner1.z, edges.corner2.z, edges.corner3.z);
    vec3 corner0 = ltcTransform(lobe, edges.corner0);
    vec3 corner1 = ltcTransform(lobe, edges.corner1);
    vec3 corner2 = ltcTransform(lobe, edges.corner2);
    vec3 corner3 = ltcTransform(lobe, edges.corner3);
    LtcFrame frame =
        ltcFrame(corner0, ltcTransformVector(lobe, edges.frame.edgeX), ltcTransformVector(lobe, edges.frame.edgeY));
    LtcLobeClip clip = ltcBeginLobeClip(surface, lobe);
    vec4 share = surface.share;
    LtcMoments moments = ltcNoMoments();
    LtcEnds ends = ltcEndsInLobe(heights.x, heights.y, corner0, corner1, frame.edgeX, share.x, clip);
    ltcAddMoments(ends.first, ends.last, share.x * frame.cornerX.z, moments);
    ends = ltcEndsInLobe(heights.y, heights.z, corner1, corner2, frame.edgeY, share.y, clip);
    ltcAddMoments(ends.first, ends.last, share.y * (frame.cornerY.z + frame.normal.z), moments);
    ends = ltcEndsInLobe(heights.z, heights.w, corner2, corner3, -frame.edgeX, share.z, clip);
    ltcAddMoments(ends.first, ends.last, share.z * (frame.normal.z - frame.cornerX.z), moments);
    ends = ltcEndsInLobe(heights.w, heights.x, corner3, corner0, -frame.edgeY, share.w, clip);
    ltcAddMoments(ends.first, ends.last, -share.w * frame.cornerY.z, moments);

    LtcClosing closing = ltcCloseAlongSurface(surface.closingTurn, lobe, clip);
    ltcAddClosingMoments(closing, lobe, moments);
    ltcAddHorizonMoments(clip.horizon.leaving, clip.horizon.entering, moments);
    return LtcSight(ltcFactor(moments.sum) * lobe.weight, ltcMeanDirection(moments), frame);
}
