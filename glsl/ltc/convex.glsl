// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// What parallelograms and triangles have in common: a convex outline of at most four edges against the cosine and against
// any number of lobes, without branches. The clip at the surface is done once for all of them. An edge is a start, a
// vector and the range of its parameter that the clips leave, so a cross product is that of the whole edge times the
// range.

/// Where a convex outline leaves the half-space z >= 0 and where it comes back, along z = 0. Where it never does, two equal
/// directions, between which a closing edge has no length.
struct LtcCrossings {
    vec2 leaving;
    vec2 entering;
};

/// What the surface leaves of an outline.
struct LtcSurfaceClip {
    vec4 share;    ///< Of each edge's length above the surface,
    bvec4 leaves;  ///< whether it ends
    bvec4 enters;  ///< or begins at the surface.
    LtcCrossings crossings;
    float closingTurn;  ///< 1 where the outline closes counter-clockwise along the surface, -1 clockwise, 0 not at all.
    float sum;          ///< Of the edges, for the cosine.
};

void ltcNoteCrossing(LtcClippedEdge clipped, inout LtcCrossings crossings) {
    crossings.leaving = clipped.leaves ? clipped.last.xy : crossings.leaving;
    crossings.entering = clipped.enters ? clipped.first.xy : crossings.entering;
}

LtcCrossings ltcNoCrossings() { return LtcCrossings(vec2(1.0, 0.0), vec2(1.0, 0.0)); }

LtcSurfaceClip ltcBeginSurfaceClip() {
    return LtcSurfaceClip(vec4(0.0), bvec4(false), bvec4(false), ltcNoCrossings(), 0.0, 0.0);
}

/// Clips edge `i` from `a` to `b` = a + edge, in the shading frame, at the surface; `crossZ` is the z of a x edge.
void ltcClipOutlineEdge(int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcSurfaceClip clip) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    clip.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * crossZ);
    ltcNoteCrossing(clipped, clip.crossings);
    clip.share[i] = clipped.share;
    clip.leaves[i] = clipped.leaves;
    clip.enters[i] = clipped.enters;
}

/// Closes the clipped outline along the surface.
void ltcCloseSurfaceClip(inout LtcSurfaceClip clip) {
    vec2 leaving = clip.crossings.leaving;
    vec2 entering = clip.crossings.entering;
    clip.closingTurn = sign(leaving.x * entering.y - leaving.y * entering.x);
    clip.sum += ltcPlaneAngle(leaving, entering, clip.closingTurn);
}

/// The form factor of a sum over the edges.
float ltcFactor(float sum) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * sum;
}

/// The sum over an outline's edges after M^-1.
struct LtcLobeSum {
    vec3 leaving;   ///< Where M^-1 takes the surface's crossings.
    vec3 entering;
    float sum;
    LtcCrossings horizon;
};

LtcLobeSum ltcBeginLobeSum(LtcSurfaceClip clip, LtcLobe lobe) {
    return LtcLobeSum(ltcTransformHorizontal(lobe, clip.crossings.leaving),
                      ltcTransformHorizontal(lobe, clip.crossings.entering), 0.0, ltcNoCrossings());
}

/// Adds what the surface has left of edge `i`, which M^-1 takes from `a` to `b` = a + edge, and what the lobe's horizon
/// leaves of that; `crossZ` is the z of a x edge.
void ltcAddLobeEdge(LtcSurfaceClip clip, int i, vec3 a, vec3 b, vec3 edge, float crossZ, inout LtcLobeSum sum) {
    float share = clip.share[i];
    vec3 first = clip.enters[i] ? sum.entering : a;
    vec3 last = clip.leaves[i] ? sum.leaving : b;
    // An edge below the surface must not count as crossing the lobe's horizon either.
    bool isKept = share > 0.0;
    LtcClippedEdge clipped = ltcClipEdge(first, last, share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    sum.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * (share * crossZ));
    ltcNoteCrossing(clipped, sum.horizon);
}

/// Closes the outline along the surface and along the lobe's horizon; the lobe's form factor as a share of the lobe above
/// the surface and times the lobe's share of the light.
float ltcCloseLobeSum(LtcSurfaceClip clip, LtcLobe lobe, LtcLobeSum sum) {
    // The surface's closing edge lies in a plane that is known. A smooth lobe at a grazing view makes it all but opposite
    // directions, of which no cross product would tell the plane.
    vec3 leaving = sum.leaving;
    vec3 entering = sum.entering;
    LtcClippedEdge closing = ltcClipEdge(leaving, entering, entering - leaving, leaving.z, entering.z);
    sum.sum += lobe.surfaceZ * ltcPlaneAngle(ltcAlongSurface(lobe, closing.first), ltcAlongSurface(lobe, closing.last),
                                               clip.closingTurn);
    ltcNoteCrossing(closing, sum.horizon);
    // What M^-1 has pushed below its own horizon closes along that.
    vec2 a = sum.horizon.leaving;
    vec2 b = sum.horizon.entering;
    sum.sum += ltcPlaneAngle(a, b, sign(a.x * b.y - a.y * b.x));
    return ltcFactor(sum.sum) * lobe.weight;
}
