// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// What parallelograms and triangles have in common: a convex outline of at most four edges against the cosine and against
// any number of lobes, without branches. The clip at the surface is done once for all of them. A plane takes at most one
// piece off: the outline leaves the half-space once and comes back once. The z of the cross product of what is left
// of an edge is that of the whole edge times the share that is left; x and y come from the ends, of which the snapped ones
// have another z than the edge.

/// Where a convex outline leaves the half-space z >= 0 and where it comes back, along z = 0. Where it never does, two equal
/// directions, between which a closing edge has no length.
struct LtcCrossings {
    vec2 leaving;
    vec2 entering;
};

LtcCrossings ltcNoCrossings() { return LtcCrossings(vec2(1.0, 0.0), vec2(1.0, 0.0)); }

/// Where the edge from `a` to `b` = a + (edge, rise) crosses z = 0: from the end that is nearer to it, since the other may
/// be so far away that it has lost the digits.
vec2 ltcCrossing(vec3 a, vec3 b, vec2 edge, float inverseRise) {
    vec3 base = abs(a.z) < abs(b.z) ? a : b;
    return base.xy - (base.z * inverseRise) * edge;
}

/// Notes where the edge crosses the horizon, if it does.
void ltcNoteCrossing(vec3 a, vec3 b, vec3 edge, inout LtcCrossings crossings) {
    vec2 crossing = ltcCrossing(a, b, edge.xy, 1.0 / (b.z - a.z));
    crossings.leaving = a.z >= 0.0 && b.z < 0.0 ? crossing : crossings.leaving;
    crossings.entering = a.z < 0.0 && b.z >= 0.0 ? crossing : crossings.entering;
}

/// 1 where the outline closes counter-clockwise along the horizon, -1 clockwise, 0 not at all.
float ltcClosingTurn(LtcCrossings crossings) {
    return sign(crossings.leaving.x * crossings.entering.y - crossings.leaving.y * crossings.entering.x);
}

/// What the surface leaves of an outline.
struct LtcSurfaceClip {
    vec4 share;  ///< Of each edge's length above the surface.
    LtcCrossings crossings;
    float closingTurn;
};

/// How much of the edge from `a` to `b` lies above the horizon.
float ltcShareAbove(vec3 a, vec3 b) {
    float part = (max(b.z, 0.0) - max(a.z, 0.0)) * (1.0 / (b.z - a.z));
    float whole = a.z >= 0.0 ? 1.0 : 0.0;
    return (a.z >= 0.0) == (b.z >= 0.0) ? whole : part;
}

/// The ends of what the surface leaves of an edge. Of one below it, whose share is 0, anything.
struct LtcEnds {
    vec3 first;
    vec3 last;
};

LtcEnds ltcEndsAbove(vec3 a, vec3 b, LtcCrossings crossings) {
    return LtcEnds(vec3(a.z >= 0.0 ? a.xy : crossings.entering, max(a.z, 0.0)),
                   vec3(b.z >= 0.0 ? b.xy : crossings.leaving, max(b.z, 0.0)));
}

/// The form factor of a sum over the edges.
float ltcFactor(float sum) {
    const float kMinusInverse2Pi = -0.159154943;
    return kMinusInverse2Pi * sum;
}

/// The surface's crossings after M^-1, and those of the lobe's horizon.
struct LtcLobeClip {
    vec3 leaving;
    vec3 entering;
    LtcCrossings horizon;
};

LtcLobeClip ltcBeginLobeClip(LtcSurfaceClip clip, LtcLobe lobe) {
    return LtcLobeClip(ltcTransformHorizontal(lobe, clip.crossings.leaving),
                       ltcTransformHorizontal(lobe, clip.crossings.entering), ltcNoCrossings());
}

/// What the lobe's horizon leaves of what the surface has left of an edge, which M^-1 takes from `imageA` to `imageB` =
/// imageA + image and which went from the height `heightA` to `heightB` above the surface before. `share` becomes that of
/// both.
LtcEnds ltcEndsInLobe(float heightA, float heightB, vec3 imageA, vec3 imageB, vec3 image, inout float share,
                      inout LtcLobeClip clip) {
    vec3 first = heightA >= 0.0 ? imageA : clip.entering;
    vec3 last = heightB >= 0.0 ? imageB : clip.leaving;
    // An edge below the surface must not count as crossing the lobe's horizon either.
    bool isKept = heightA >= 0.0 || heightB >= 0.0;
    bool leaves = isKept && first.z >= 0.0 && last.z < 0.0;
    bool enters = isKept && first.z < 0.0 && last.z >= 0.0;
    float inverseRise = share / (last.z - first.z);
    vec2 crossing = ltcCrossing(first, last, image.xy, inverseRise);
    clip.horizon.leaving = leaves ? crossing : clip.horizon.leaving;
    clip.horizon.entering = enters ? crossing : clip.horizon.entering;
    float firstHeight = max(first.z, 0.0);
    float lastHeight = max(last.z, 0.0);
    share = first.z >= 0.0 ? share : 0.0;
    share = leaves || enters ? (lastHeight - firstHeight) * inverseRise : share;
    return LtcEnds(vec3(enters ? crossing : first.xy, firstHeight), vec3(leaves ? crossing : last.xy, lastHeight));
}

/// The outline's closing edge along the surface, as far as it is above the lobe's horizon: directions in the image of that
/// plane, turned around where surfaceZ < 0.
struct LtcClosing {
    vec2 first;
    vec2 last;
    float turn;
};

/// Closes the outline along the surface and notes where that crosses the horizon: on the line that the two planes have in
/// common, their y axis, at the end of it that the turn goes by.
LtcClosing ltcCloseAlongSurface(float closingTurn, LtcLobe lobe, inout LtcLobeClip clip) {
    bool keepsLeaving = clip.leaving.z >= 0.0;
    bool keepsEntering = clip.entering.z >= 0.0;
    vec2 corner = vec2(0.0, keepsLeaving == (lobe.m31 >= 0.0) ? closingTurn : -closingTurn);
    clip.horizon.leaving = keepsLeaving && !keepsEntering ? corner : clip.horizon.leaving;
    clip.horizon.entering = !keepsLeaving && keepsEntering ? corner : clip.horizon.entering;
    // Along the surface a vector (x, y) of the surface is as long as (m11 x / surfaceZ, y).
    LtcClosing closing;
    closing.first = keepsLeaving ? clip.leaving.xy : corner;
    closing.last = keepsEntering ? clip.entering.xy : corner;
    closing.first.y *= lobe.surfaceZ;
    closing.last.y *= lobe.surfaceZ;
    closing.turn = keepsLeaving || keepsEntering ? closingTurn : 0.0;
    return closing;
}

/// The sum over an outline's edges in a lobe and the closing edges along the surface and along the lobe's horizon: the
/// lobe's form factor as a share of the lobe above the surface and times the lobe's share of the light.
float ltcLobeFactorOf(float sum, LtcSurfaceClip surface, LtcLobe lobe, LtcLobeClip clip) {
    // The surface's closing edge lies in a plane that is known. A smooth lobe at a grazing view makes it all but opposite
    // directions, of which no cross product would tell the plane.
    LtcClosing closing = ltcCloseAlongSurface(surface.closingTurn, lobe, clip);
    sum += lobe.surfaceZ * ltcPlaneAngle(closing.first, closing.last, closing.turn);
    // What M^-1 has pushed below its own horizon closes along that.
    sum += ltcPlaneAngle(clip.horizon.leaving, clip.horizon.entering, ltcClosingTurn(clip.horizon));
    return ltcFactor(sum) * lobe.weight;
}
