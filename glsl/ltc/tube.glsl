// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/tube_clip.glsl"
#include "ltc/tube_strip.glsl"

/// What the surface has left of a tube's outline, while its pieces are clipped at a lobe's horizon.
struct LtcOutline {
    float sum;
    vec3 surfaceLeaving;  ///< Where M^-1 takes the surface's crossings,
    vec3 surfaceEntering;
    bool keepsLeaving;  ///< and whether they are above the lobe's horizon.
    bool keepsEntering;
    vec2 horizonLeaving;
    vec2 horizonEntering;
};

/// A part of a cap's arc that the surface leaves, and whether its ends are above the lobe's horizon.
struct LtcCapArc {
    LtcConePoint first;
    LtcConePoint last;
    bool keepsFirst;
    bool keepsLast;
    bool isReflex;
    bool exists;
};

/// Adds what the horizon leaves of `arc` to the angles of `sum`.
LtcArcSum ltcAddCapArc(LtcCone cone, LtcConeArcs arcs, LtcConeCut horizon, LtcConePoint horizonIn,
                       LtcConePoint horizonOut, LtcCapArc arc, LtcArcSum sum, inout LtcOutline outline) {
    bool cuts = horizon.cuts && arc.exists;
    bool cutsPiece = cuts && arc.keepsFirst && arc.keepsLast &&
                     ltcIsInArc(arc.first.point, arc.last.point, arc.isReflex, -horizon.top);
    bool keepsPiece = cuts && !arc.keepsFirst && !arc.keepsLast &&
                      ltcIsInArc(arc.first.point, arc.last.point, arc.isReflex, horizon.top);
    bool exists = arc.exists && (arc.keepsFirst || arc.keepsLast || keepsPiece);
    bool leaves = exists && (!arc.keepsLast || cutsPiece);
    bool enters = exists && (!arc.keepsFirst || cutsPiece);
    vec2 leaving = (cone.a.xy * horizonOut.point.x + cone.b.xy * horizonOut.point.y + cone.c.xy) * horizonOut.inverse;
    vec2 entering = (cone.a.xy * horizonIn.point.x + cone.b.xy * horizonIn.point.y + cone.c.xy) * horizonIn.inverse;
    outline.horizonLeaving = leaves ? leaving : outline.horizonLeaving;
    outline.horizonEntering = enters ? entering : outline.horizonEntering;
    LtcArcSum part = ltcBeginArcs(arcs, ltcSelect(arc.keepsFirst, arc.first, horizonIn),
                                  ltcSelect(leaves, horizonOut, arc.last));
    sum = ltcAddArcs(arcs, sum, part, exists);
    part = ltcBeginArcs(arcs, horizonIn, arc.last);
    return ltcAddArcs(arcs, sum, part, cutsPiece);
}

LtcConePoint ltcPointTowards(LtcCone cone, LtcConeArcs arcs, vec3 direction) {
    vec2 point = vec2(dot(direction, cone.a), dot(direction, cone.b)) / max(cone.squares.xy, 1e-36);
    return ltcConePoint(arcs, ltcUnit(point));
}

/// Adds what the surface has left of a cap, whose outline starts towards `a` and ends towards `b` after M^-1.
void ltcAddCap(LtcCapClip cap, LtcLobe lobe, vec3 a, vec3 b, inout LtcOutline outline) {
    LtcCone cone = ltcLobeCone(cap.disk, lobe);
    LtcConeCut horizon = ltcCutCone(vec3(cone.a.z, cone.b.z, cone.c.z));
    LtcConeArcs arcs = ltcConeArcs(cone);
    LtcConePoint surfaceOut = ltcPointTowards(cone, arcs, outline.surfaceLeaving);
    LtcConePoint surfaceIn = ltcPointTowards(cone, arcs, outline.surfaceEntering);
    LtcConePoint first = ltcPointTowards(cone, arcs, a);
    LtcConePoint last = ltcPointTowards(cone, arcs, b);
    // A plane that has the cone's axis above it cuts off half of the outline at most.
    bool isReflex = ltcIsReflex(first.point, last.point, cap.isNear);
    bool isMost = isReflex && dot(first.point, last.point) > 0.5 && lobe.m11 * cone.c.z >= lobe.m31 * cone.c.x;
    first = ltcSelect(cap.keepsFirst, first, surfaceIn);
    last = ltcSelect(cap.keepsLast, last, surfaceOut);
    bool keepsFirst = cap.keepsFirst ? a.z >= 0.0 : outline.keepsEntering;
    bool keepsLast = cap.keepsLast ? b.z >= 0.0 : outline.keepsLeaving;
    LtcCapArc arc;
    arc.first = first;
    arc.last = ltcSelect(cap.cutsPiece, surfaceOut, last);
    arc.keepsFirst = keepsFirst;
    arc.keepsLast = cap.cutsPiece ? outline.keepsLeaving : keepsLast;
    bool isWhole = cap.keepsFirst && cap.keepsLast && !cap.cutsPiece;
    arc.isReflex = isWhole ? isReflex : ltcIsReflex(arc.first.point, arc.last.point, isMost && !cap.cutsPiece);
    arc.exists = cap.exists;
    LtcConePoint horizonIn = ltcConePoint(arcs, horizon.entering);
    LtcConePoint horizonOut = ltcConePoint(arcs, horizon.leaving);
    LtcArcSum sum = LtcArcSum(vec2(1.0, 0.0), vec2(1.0, 0.0), vec2(1.0, 0.0), vec2(1.0));
    sum = ltcAddCapArc(cone, arcs, horizon, horizonIn, horizonOut, arc, sum, outline);
    arc.first = surfaceIn;
    arc.last = last;
    arc.keepsFirst = outline.keepsEntering;
    arc.keepsLast = keepsLast;
    arc.isReflex = ltcIsReflex(arc.first.point, arc.last.point, false);
    arc.exists = cap.cutsPiece;
    sum = ltcAddCapArc(cone, arcs, horizon, horizonIn, horizonOut, arc, sum, outline);
    outline.sum += ltcArcIntegral(arcs, sum, isMost && horizon.plane.z >= 0.0, 0.01);
}

/// Adds what the surface has left of an edge, which M^-1 takes from `a` to `b` = a + edge.
void ltcAddTubeEdge(LtcTubeEdge clip, vec3 a, vec3 b, vec3 edge, inout LtcOutline outline) {
    vec3 first = clip.enters ? outline.surfaceEntering : a;
    vec3 last = clip.leaves ? outline.surfaceLeaving : b;
    // Of an edge below the surface a point may be left, on a side of the lobe's horizon of its own.
    bool isKept = clip.share > 0.0 || clip.leaves || clip.enters;
    LtcClippedEdge kept = ltcClipEdge(first, last, clip.share * edge, isKept ? first.z : 0.0, isKept ? last.z : 0.0);
    outline.sum += ltcEdgeIntegral(kept.first, kept.last, kept.share * clip.share * ltcCrossZ(a, edge));
    outline.horizonLeaving = kept.leaves ? kept.last.xy : outline.horizonLeaving;
    outline.horizonEntering = kept.enters ? kept.first.xy : outline.horizonEntering;
}

/// The angle between two directions in a plane.
float ltcAngleBetween(vec2 a, vec2 b) {
    float inverse = inversesqrt(max(dot(a, a) * dot(b, b), 1e-36));
    return ltcAngleOf(dot(a, b) * inverse, abs(a.x * b.y - a.y * b.x) * inverse);
}

/// M^-1 v for a point of contact, snapped to the lobe's horizon by less than `reach`, a small share of a cap's height.
vec3 ltcSnapTouch(LtcLobe lobe, vec3 v, float reach) {
    v = ltcTimes(lobe, v);
    v.z = abs(v.z) > min(1e-6 * max(abs(v.x), abs(v.y)), reach) ? v.z : 0.0;
    return v;
}

/// The form factor for a lobe, of a tube that the point is outside of.
float ltcLobeFactor(LtcTube tube, LtcTubeClip clip, LtcLobe lobe) {
    // Two horizons that are one but for rounding are one.
    lobe.m31 = abs(lobe.m31) > 2e-6 * abs(lobe.m33) ? lobe.m31 : 0.0;
    float reach = 0.01 * tube.radius * sqrt(lobe.m31 * lobe.m31 + lobe.m33 * lobe.m33);
    vec3 startLow = ltcSnapTouch(lobe, clip.low.a, reach);
    vec3 startHigh = ltcSnapTouch(lobe, clip.high.b, reach);
    vec3 endLow = ltcSnapTouch(lobe, clip.low.b, reach);
    vec3 endHigh = ltcSnapTouch(lobe, clip.high.a, reach);
    vec3 edge = ltcTimes(lobe, tube.axis);
    // Not snapped: the side of the lobe's horizon is told by x, however small the angle between the planes is.
    LtcOutline outline;
    outline.sum = 0.0;
    outline.surfaceLeaving = vec3(lobe.m11 * clip.leaving.x, clip.leaving.y, lobe.m31 * clip.leaving.x);
    outline.surfaceEntering = vec3(lobe.m11 * clip.entering.x, clip.entering.y, lobe.m31 * clip.entering.x);
    outline.keepsLeaving = outline.surfaceLeaving.z >= 0.0;
    outline.keepsEntering = outline.surfaceEntering.z >= 0.0;
    outline.horizonLeaving = vec2(0.0);
    outline.horizonEntering = vec2(0.0);
    ltcAddTubeEdge(clip.low, startLow, endLow, edge, outline);
    ltcAddTubeEdge(clip.high, endHigh, startHigh, -edge, outline);
    ltcAddCap(clip.end, lobe, endLow, endHigh, outline);
    ltcAddCap(clip.start, lobe, startHigh, startLow, outline);

    // The closing edges: along the surface above the lobe's horizon, where one of the crossings is not up to the line
    // that both planes share, and along the horizon from there.
    bool keepsOut = clip.crosses && outline.keepsLeaving;
    bool keepsIn = clip.crosses && outline.keepsEntering;
    vec2 corner = vec2(0.0, (lobe.m31 > 0.0) == keepsOut ? 1.0 : -1.0);
    vec2 from = keepsOut ? ltcAlongSurface(lobe, outline.surfaceLeaving) : corner;
    vec2 to = keepsIn ? ltcAlongSurface(lobe, outline.surfaceEntering) : corner;
    outline.sum += keepsIn || keepsOut ? lobe.surfaceZ * ltcAngleBetween(from, to) : 0.0;
    from = keepsOut && !keepsIn ? corner : outline.horizonLeaving;
    to = keepsIn && !keepsOut ? corner : outline.horizonEntering;
    // An end that nothing has noted is where the other one is: the horizon passes through a corner.
    from = dot(from, from) > 0.0 ? from : to;
    to = dot(to, to) > 0.0 ? to : from;
    outline.sum += ltcAngleBetween(from, to);

    const float kInverse2Pi = 0.159154943;
    float squareWidth;
    float strip = ltcStripFactor(tube, lobe, squareWidth);
    return squareWidth < 1e-4 && !tube.isEndOn ? strip : lobe.weight * kInverse2Pi * outline.sum;
}

/// The form factor for the clamped cosine.
float ltcCosineFactor(LtcTube tube, LtcTubeClip clip) {
    const float kInverse2Pi = 0.159154943;
    float squareWidth;
    float strip = ltcStripFactor(tube, LtcLobe(1.0, 0.0, 0.0, 1.0, 1.0, 1.0), squareWidth);
    return squareWidth < 1e-4 && !tube.isEndOn ? strip : kInverse2Pi * clip.sum;
}
