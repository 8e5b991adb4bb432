// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/convex.glsl"

/// A parallelogram relative to the shaded point, in the shading frame or after M^-1.
struct LtcParallelogramShape {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 corner3;
    vec3 edgeX;  ///< As given: products of theirs keep all digits.
    vec3 edgeY;
};

/// The same, and what the surface leaves of it.
struct LtcParallelogram {
    LtcParallelogramShape shape;
    LtcSurfaceClip clip;
    float sum;  ///< Over its edges, for the cosine.
};

LtcParallelogramShape ltcParallelogramShape(vec3 p, vec3 edgeX, vec3 edgeY) {
    return LtcParallelogramShape(ltcSnapToHorizon(p), ltcSnapToHorizon(p + edgeX), ltcSnapToHorizon(p + edgeX + edgeY),
                                 ltcSnapToHorizon(p + edgeY), edgeX, edgeY);
}

/// The shape after M^-1.
LtcParallelogramShape ltcTransform(LtcLobe lobe, LtcParallelogramShape shape) {
    return LtcParallelogramShape(ltcTransform(lobe, shape.corner0), ltcTransform(lobe, shape.corner1),
                                 ltcTransform(lobe, shape.corner2), ltcTransform(lobe, shape.corner3),
                                 ltcTransformVector(lobe, shape.edgeX), ltcTransformVector(lobe, shape.edgeY));
}

/// z of each corner x the edge that begins there.
vec4 ltcCrossesZ(LtcParallelogramShape shape) {
    float crossX = ltcCrossZ(shape.corner0, shape.edgeX);
    float crossY = ltcCrossZ(shape.corner0, shape.edgeY);
    float crossXY = ltcCrossZ(shape.edgeX, shape.edgeY);
    return vec4(crossX, crossY + crossXY, crossXY - crossX, -crossY);
}

/// What lies above the plane z = 0.
LtcSurfaceClip ltcClipShape(LtcParallelogramShape shape) {
    LtcSurfaceClip clip;
    clip.crossings = ltcNoCrossings();
    ltcNoteCrossing(shape.corner0, shape.corner1, shape.edgeX, clip.crossings);
    ltcNoteCrossing(shape.corner1, shape.corner2, shape.edgeY, clip.crossings);
    ltcNoteCrossing(shape.corner2, shape.corner3, -shape.edgeX, clip.crossings);
    ltcNoteCrossing(shape.corner3, shape.corner0, -shape.edgeY, clip.crossings);
    clip.closingTurn = ltcClosingTurn(clip.crossings);
    clip.share = vec4(ltcShareAbove(shape.corner0, shape.corner1), ltcShareAbove(shape.corner1, shape.corner2),
                      ltcShareAbove(shape.corner2, shape.corner3), ltcShareAbove(shape.corner3, shape.corner0));
    return clip;
}

/// The sum over the edges of what a clip leaves, and over the edge that closes that along the plane.
float ltcClippedSum(LtcParallelogramShape shape, LtcSurfaceClip clip) {
    vec4 crosses = ltcCrossesZ(shape);
    LtcCrossings crossings = clip.crossings;
    LtcEnds ends = ltcEndsAbove(shape.corner0, shape.corner1, crossings);
    float sum = ltcEdgeIntegral(ends.first, ends.last, clip.share.x * crosses.x);
    ends = ltcEndsAbove(shape.corner1, shape.corner2, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.y * crosses.y);
    ends = ltcEndsAbove(shape.corner2, shape.corner3, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.z * crosses.z);
    ends = ltcEndsAbove(shape.corner3, shape.corner0, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.w * crosses.w);
    return sum + ltcPlaneAngle(crossings.leaving, crossings.entering, clip.closingTurn);
}

/// The parallelogram with the corners `p`, `p + edgeX`, `p + edgeX + edgeY`, `p + edgeY`, in the shading frame and
/// relative to the shaded point, clipped at the surface.
LtcParallelogram ltcClipParallelogram(vec3 p, vec3 edgeX, vec3 edgeY) {
    LtcParallelogramShape shape = ltcParallelogramShape(p, edgeX, edgeY);
    LtcSurfaceClip clip = ltcClipShape(shape);
    return LtcParallelogram(shape, clip, ltcClippedSum(shape, clip));
}

/// The form factor for the clamped cosine, 0 to 1 where the corners turn counter-clockwise seen from the side that the
/// point is on, else negative.
float ltcCosineFactor(LtcParallelogram outline) { return ltcFactor(outline.sum); }

/// The form factor for a lobe, as a share of the lobe above the surface and times the lobe's share; signed as
/// ltcCosineFactor().
float ltcLobeFactor(LtcParallelogram outline, LtcLobe lobe) {
    vec4 heights = vec4(outline.shape.corner0.z, outline.shape.corner1.z, outline.shape.corner2.z,
                        outline.shape.corner3.z);
    LtcParallelogramShape image = ltcTransform(lobe, outline.shape);
    LtcLobeClip clip = ltcBeginLobeClip(outline.clip, lobe);
    vec4 crosses = ltcCrossesZ(image);
    vec4 share = outline.clip.share;
    LtcEnds ends = ltcEndsInLobe(heights.x, heights.y, image.corner0, image.corner1, image.edgeX, share.x, clip);
    float sum = ltcEdgeIntegral(ends.first, ends.last, share.x * crosses.x);
    ends = ltcEndsInLobe(heights.y, heights.z, image.corner1, image.corner2, image.edgeY, share.y, clip);
    sum += ltcEdgeIntegral(ends.first, ends.last, share.y * crosses.y);
    ends = ltcEndsInLobe(heights.z, heights.w, image.corner2, image.corner3, -image.edgeX, share.z, clip);
    sum += ltcEdgeIntegral(ends.first, ends.last, share.z * crosses.z);
    ends = ltcEndsInLobe(heights.w, heights.x, image.corner3, image.corner0, -image.edgeY, share.w, clip);
    sum += ltcEdgeIntegral(ends.first, ends.last, share.w * crosses.w);
    return ltcLobeFactorOf(sum, outline.clip, lobe, clip);
}
