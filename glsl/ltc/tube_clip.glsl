// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/tube_outline.glsl"

// The clip of a tube's outline at the surface, done once for the cosine and for all lobes, and the cosine's sum. The
// outline is convex: it crosses the surface at most once downwards and once upwards.

/// A cap's arc in the shading frame, and what the surface leaves of it: up to two arcs.
struct LtcCapClip {
    LtcEllipse disk;
    bool exists;     ///< Something is left.
    bool keepsFirst; ///< Its ends are above the surface.
    bool keepsLast;
    bool cutsPiece;  ///< Between them a piece is not.
    bool isNear;     ///< The arc is all of the disk's outline where its ends are one.
};

/// A straight edge, and what the surface leaves of it.
struct LtcTubeEdge {
    vec3 a;  ///< Snapped to the surface.
    vec3 b;
    float share;
    bool leaves;
    bool enters;
};

struct LtcTubeClip {
    LtcTubeEdge low;   ///< From the start to the end.
    LtcTubeEdge high;  ///< From the end to the start.
    LtcCapClip start;
    LtcCapClip end;
    vec2 leaving;  ///< Where the outline crosses the surface, in its plane.
    vec2 entering;
    bool crosses;
    float sum;  ///< Over the edges, for the cosine.
};

/// Whether `point` of an outline lies inside the arc from `first` to `last`.
bool ltcIsInArc(vec2 first, vec2 last, bool isReflex, vec2 point) {
    float fromFirst = first.x * point.y - first.y * point.x;
    float toLast = point.x * last.y - point.y * last.x;
    return isReflex ? fromFirst >= 0.0 || toLast >= 0.0 : fromFirst > 0.0 && toLast > 0.0;
}

/// Whether the arc from `first` to `last` turns by more than pi; `isNear` decides where the two are one but for
/// rounding.
bool ltcIsReflex(vec2 first, vec2 last, bool isNear) {
    float turn = first.x * last.y - first.y * last.x;
    return abs(turn) > 1e-4 || dot(first, last) < 0.0 ? turn < 0.0 : isNear;
}

/// The unit vector along `v`, any for none.
vec2 ltcUnit(vec2 v) {
    float square = dot(v, v);
    return square > 1e-36 ? v * inversesqrt(max(square, 1e-36)) : vec2(1.0, 0.0);
}

LtcTubeEdge ltcClipTubeEdge(vec3 a, vec3 b, vec3 edge, inout LtcTubeClip clip) {
    LtcClippedEdge clipped = ltcClipEdge(a, b, edge, a.z, b.z);
    clip.sum += ltcEdgeIntegral(clipped.first, clipped.last, clipped.share * ltcCrossZ(a, edge));
    clip.leaving = clipped.leaves ? clipped.last.xy : clip.leaving;
    clip.entering = clipped.enters ? clipped.first.xy : clip.entering;
    clip.crosses = clip.crosses || clipped.leaves || clipped.enters;
    return LtcTubeEdge(a, b, clipped.share, clipped.leaves, clipped.enters);
}

/// Clips the cap's arc from the direction `a` to `b`, counter-clockwise about the disk's centre.
///
/// On the unit sphere, along an arc by the angle t of a circle of the sine s and the cosine k about the unit axis d,
/// the integral of r x r' is s^2 t d + k d x (last - first).
LtcCapClip ltcClipCap(LtcEllipse disk, vec3 a, vec3 b, bool isNear, bool isSeen, inout LtcTubeClip clip) {
    vec2 first = ltcUnit(vec2(dot(a, disk.halfAxisX), dot(a, disk.halfAxisY)));
    vec2 last = ltcUnit(vec2(dot(b, disk.halfAxisX), dot(b, disk.halfAxisY)));
    bool isReflex = ltcIsReflex(first, last, isNear);
    // halfAxisX holds the highest point, halfAxisY is level.
    float level = disk.center.z / max(disk.halfAxisX.z, 1e-15);
    bool cuts = abs(level) < 1.0;
    level = clamp(level, -1.0, 1.0);
    vec2 leaving = vec2(-level, sqrt((1.0 - level) * (1.0 + level)));
    vec2 entering = vec2(leaving.x, -leaving.y);

    LtcCapClip cap;
    cap.disk = disk;
    cap.isNear = isNear;
    cap.keepsFirst = a.z >= 0.0;
    cap.keepsLast = b.z >= 0.0;
    bool keepsBoth = cap.keepsFirst && cap.keepsLast;
    bool keepsNone = !cap.keepsFirst && !cap.keepsLast;
    // The outline leaves and comes back within the arc only if it does so nowhere else.
    bool mayTurn = isSeen && cuts && !clip.crosses;
    cap.cutsPiece = mayTurn && keepsBoth && ltcIsInArc(first, last, isReflex, vec2(-1.0, 0.0));
    bool keepsPiece = mayTurn && keepsNone && ltcIsInArc(first, last, isReflex, vec2(1.0, 0.0));
    cap.exists = isSeen && (!keepsNone || keepsPiece);
    bool leaves = cap.exists && (!cap.keepsLast || cap.cutsPiece);
    bool enters = cap.exists && (!cap.keepsFirst || cap.cutsPiece);
    vec2 middle = disk.center.xy + leaving.x * disk.halfAxisX.xy;
    vec2 across = leaving.y * disk.halfAxisY.xy;
    clip.leaving = leaves ? middle + across : clip.leaving;
    clip.entering = enters ? middle - across : clip.entering;
    clip.crosses = clip.crosses || leaves || enters;

    // The angle of what is left, 0 to 2 pi, and its chords.
    bool isMost = isReflex && dot(first, last) > 0.5 && disk.center.z >= 0.0;
    vec2 from = cap.keepsFirst ? first : entering;
    vec2 to = cap.keepsLast ? last : leaving;
    vec2 turn = vec2(dot(from, to), from.x * to.y - from.y * to.x);
    vec2 piece = vec2(dot(leaving, entering), leaving.x * entering.y - leaving.y * entering.x);
    vec2 rest = vec2(dot(turn, piece), turn.y * piece.x - turn.x * piece.y);
    turn = cap.cutsPiece ? rest : turn;
    float angle = ltcAngleOf(turn.x, abs(turn.y));
    angle = turn.y < 0.0 ? -angle : angle;
    angle += (abs(turn.y) > 1e-2 || turn.x < 0.0 ? turn.y < 0.0 : isMost) ? 6.28318531 : 0.0;
    vec2 chord = to - from - (cap.cutsPiece ? entering - leaving : vec2(0.0));
    // d x (X x + Y y) = x Y - y X.
    float square = dot(disk.halfAxisY, disk.halfAxisY);
    float inverse = inversesqrt(max(dot(disk.center, disk.center), 1e-30));
    float sum = square * disk.center.z * inverse * angle -
                chord.y * disk.halfAxisX.z * dot(disk.center, disk.center) * inverse;
    clip.sum += cap.exists ? sum : 0.0;
    return cap;
}

/// Clips the outline of a tube at the surface.
LtcTubeClip ltcClipTube(LtcTube tube) {
    vec3 startLow = ltcSnapToHorizon(tube.start + tube.offsetLow);
    vec3 startHigh = ltcSnapToHorizon(tube.start + tube.offsetHigh);
    vec3 endLow = ltcSnapToHorizon(tube.end + tube.offsetLow);
    vec3 endHigh = ltcSnapToHorizon(tube.end + tube.offsetHigh);
    LtcTubeClip clip;
    clip.leaving = vec2(1.0, 0.0);
    clip.entering = vec2(1.0, 0.0);
    clip.crosses = false;
    clip.sum = 0.0;
    clip.low = ltcClipTubeEdge(startLow, endLow, tube.axis, clip);
    clip.high = ltcClipTubeEdge(endHigh, startHigh, -tube.axis, clip);
    clip.end = ltcClipCap(ltcEllipseOfSphere(tube.end, tube.radius), endLow, endHigh, tube.isEndNear,
                          tube.isEndNear || !tube.isEndOn, clip);
    clip.start = ltcClipCap(ltcEllipseOfSphere(tube.start, tube.radius), startHigh, startLow, tube.isStartNear,
                            tube.isStartNear || !tube.isEndOn, clip);
    float inverse = inversesqrt(max(dot(clip.leaving, clip.leaving) * dot(clip.entering, clip.entering), 1e-36));
    float sine = abs(clip.leaving.x * clip.entering.y - clip.leaving.y * clip.entering.x) * inverse;
    clip.sum += clip.crosses ? ltcAngleOf(dot(clip.leaving, clip.entering) * inverse, sine) : 0.0;
    return clip;
}
