// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/convex.glsl"

/// A triangle in the shading frame, relative to the shaded point, and what the surface leaves of it.
struct LtcTriangle {
    vec3 corner0;  ///< Snapped to the horizon, in the order of the outline.
    vec3 corner1;
    vec3 corner2;
    vec3 edgeX;  ///< From corner 0 to the others, as given: products of theirs keep all digits.
    vec3 edgeY;
    LtcSurfaceClip clip;
    float sum;  ///< Over its edges, for the cosine.
};

/// z of each corner x the edge that begins there.
vec3 ltcTriangleCrossesZ(vec3 corner0, vec3 edgeX, vec3 edgeY) {
    float crossX = ltcCrossZ(corner0, edgeX);
    float crossY = ltcCrossZ(corner0, edgeY);
    return vec3(crossX, crossY - crossX + ltcCrossZ(edgeX, edgeY), -crossY);
}

/// The triangle with the corners `p`, `p + edgeX`, `p + edgeY`, in the shading frame and relative to the shaded point,
/// clipped at the surface.
LtcTriangle ltcClipTriangle(vec3 p, vec3 edgeX, vec3 edgeY) {
    vec3 corner0 = ltcSnapToHorizon(p);
    vec3 corner1 = ltcSnapToHorizon(p + edgeX);
    vec3 corner2 = ltcSnapToHorizon(p + edgeY);
    LtcSurfaceClip clip;
    clip.crossings = ltcNoCrossings();
    ltcNoteCrossing(corner0, corner1, edgeX, clip.crossings);
    ltcNoteCrossing(corner1, corner2, edgeY - edgeX, clip.crossings);
    ltcNoteCrossing(corner2, corner0, -edgeY, clip.crossings);
    clip.closingTurn = ltcClosingTurn(clip.crossings);
    clip.share = vec4(ltcShareAbove(corner0, corner1), ltcShareAbove(corner1, corner2),
                      ltcShareAbove(corner2, corner0), 0.0);
    vec3 crosses = ltcTriangleCrossesZ(corner0, edgeX, edgeY);
    LtcCrossings crossings = clip.crossings;
    float sum = ltcPlaneAngle(crossings.leaving, crossings.entering, clip.closingTurn);
    LtcEnds ends = ltcEndsAbove(corner0, corner1, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.x * crosses.x);
    ends = ltcEndsAbove(corner1, corner2, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.y * crosses.y);
    ends = ltcEndsAbove(corner2, corner0, crossings);
    sum += ltcEdgeIntegral(ends.first, ends.last, clip.share.z * crosses.z);
    return LtcTriangle(corner0, corner1, corner2, edgeX, edgeY, clip, sum);
}

/// As those of a parallelogram.
float ltcCosineFactor(LtcTriangle outline) { return ltcFactor(outline.sum); }

float ltcLobeFactor(LtcTriangle outline, LtcLobe lobe) {
    vec3 heights = vec3(outline.corner0.z, outline.corner1.z, outline.corner2.z);
    vec3 corner0 = ltcTransform(lobe, outline.corner0);
    vec3 corner1 = ltcTransform(lobe, outline.corner1);
    vec3 corner2 = ltcTransform(lobe, outline.corner2);
    vec3 edgeX = ltcTransformVector(lobe, outline.edgeX);
    vec3 edgeY = ltcTransformVector(lobe, outline.edgeY);
    LtcLobeClip clip = ltcBeginLobeClip(outline.clip, lobe);
    vec3 crosses = ltcTriangleCrossesZ(corner0, edgeX, edgeY);
    vec3 share = outline.clip.share.xyz;
    LtcEnds ends = ltcEndsInLobe(heights.x, heights.y, corner0, corner1, edgeX, share.x, clip);
    float sum = ltcEdgeIntegral(ends.first, ends.last, share.x * crosses.x);
    ends = ltcEndsInLobe(heights.y, heights.z, corner1, corner2, edgeY - edgeX, share.y, clip);
    sum += ltcEdgeIntegral(ends.first, ends.last, share.y * crosses.y);
    ends = ltcEndsInLobe(heights.z, heights.x, corner2, corner0, -edgeY, share.z, clip);
    sum += ltcEdgeIntegral(ends.first, ends.last, share.z * crosses.z);
    return ltcLobeFactorOf(sum, outline.clip, lobe, clip);
}
