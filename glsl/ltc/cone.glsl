// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/cone_arcs.glsl"
#include "ltc/cone_section.glsl"
#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// The cone of directions to an ellipse, against the cosine and against lobes, without branches.

/// How a plane through the origin cuts the cone: where the outline, as it turns with t, goes below and comes back, each
/// as cosine and sine of t. A cone that is not cut has two equal points, those that are nearest to the plane.
struct LtcConeCut {
    vec3 plane;  ///< Height above the plane: dot(plane, vec3(cos t, sin t, 1)).
    vec2 top;    ///< The highest point.
    vec2 leaving;
    vec2 entering;
    float chord;  ///< |leaving x entering| of the outline's vectors, over the volume.
    bool cuts;
    bool touches;  ///< Or misses: what is on the other side is a ten-thousandth as high as the cone, or nothing.
};

/// `plane` holds the heights of a, b and c above it.
LtcConeCut ltcCutCone(vec3 plane) {
    LtcConeCut cut;
    cut.plane = plane;
    // A plane at right angles to the axis has no highest point; any does.
    vec2 rise = dot(plane.xy, plane.xy) > 1e-30 ? plane.xy : vec2(1e-15, 0.0);
    float inverse = inversesqrt(dot(rise, rise));
    cut.top = rise * inverse;
    float level = plane.z * inverse;
    cut.cuts = abs(level) < 1.0;
    cut.touches = abs(level) > 0.9999;
    level = clamp(level, -1.0, 1.0);
    float halfChord = sqrt((1.0 - level) * (1.0 + level));
    cut.chord = 2.0 * halfChord * inverse;
    vec2 across = halfChord * vec2(-cut.top.y, cut.top.x);
    cut.leaving = across - level * cut.top;
    cut.entering = -across - level * cut.top;
    return cut;
}

/// The form factor of a cone for the clamped cosine; `heights` holds those of its half axes and centre, in its arcs'
/// order.
float ltcArcsCosineFactor(LtcConeArcs arcs, vec3 heights, float volume) {
    LtcConeCut cut = ltcCutCone(heights);
    LtcConePoint entering = ltcConePoint(arcs, cut.entering);
    LtcConePoint leaving = ltcConePoint(arcs, cut.leaving);
    float sum = ltcArcIntegral(arcs, ltcBeginArcs(arcs, entering, leaving), heights.z >= 0.0, 2e-6);
    sum += ltcAngleOf(ltcCosineBetween(arcs, entering, leaving),
                      cut.chord * volume * entering.inverse * leaving.inverse);
    const float kInverse2Pi = 0.159154943;
    return kInverse2Pi * sum;
}

float ltcConeCosineFactor(LtcCone cone) {
    return ltcArcsCosineFactor(ltcConeArcs(cone), vec3(cone.a.z, cone.b.z, cone.c.z), cone.volume);
}

/// The form factor for `lobe` of a cone that M^-1 has been applied to.
float ltcConeLobeFactor(LtcCone cone, LtcLobe lobe) {
    // The surface, after M^-1.
    float scale = inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    vec2 slope = vec2(lobe.m11, lobe.m31) * scale;
    LtcConeCut surface = ltcCutCone(slope.x * vec3(cone.a.z, cone.b.z, cone.c.z) -
                                    slope.y * vec3(cone.a.x, cone.b.x, cone.c.x));
    LtcConeCut horizon = ltcCutCone(vec3(cone.a.z, cone.b.z, cone.c.z));
    LtcConeArcs arcs = ltcConeArcs(cone);
    LtcConePoint surfaceIn = ltcConePoint(arcs, surface.entering);
    LtcConePoint surfaceOut = ltcConePoint(arcs, surface.leaving);
    LtcConePoint horizonIn = ltcConePoint(arcs, horizon.entering);
    LtcConePoint horizonOut = ltcConePoint(arcs, horizon.leaving);
    vec3 surfaceInDirection = ltcConeDirection(cone, surfaceIn);
    vec3 surfaceOutDirection = ltcConeDirection(cone, surfaceOut);
    vec3 horizonInDirection = ltcConeDirection(cone, horizonIn);
    vec3 horizonOutDirection = ltcConeDirection(cone, horizonOut);

    // Which of the surface's crossings are above the lobe's horizon. Both planes contain the y axis, so that is told by
    // the side of it, however small the angle between the planes is.
    float alongIn = dot(surfaceInDirection.xz, slope);
    float alongOut = dot(surfaceOutDirection.xz, slope);
    bool keepsIn = surface.cuts && slope.y * alongIn >= 0.0;
    bool keepsOut = surface.cuts && slope.y * alongOut >= 0.0;
    bool keepsBoth = keepsIn && keepsOut;
    bool keepsNone = !keepsIn && !keepsOut;
    // What the lobe's horizon cuts off, and what it leaves, lies on one side of the surface in the cases where it
    // matters.
    float topAbove = dot(surface.plane.xy, horizon.top);
    bool bottomIsAbove = surface.plane.z - topAbove > 0.0;
    // Of a light that touches the surface, the top itself may lie in it.
    bool topIsAbove = surface.plane.z + (surface.touches ? 0.0 : topAbove) >= 0.0;

    // Where both are kept the horizon may cut off a piece between them.
    bool cutsPiece = keepsBoth && bottomIsAbove;
    LtcArcSum arcSum = ltcBeginArcs(arcs, ltcSelect(keepsIn, surfaceIn, horizonIn),
                                    ltcSelect(keepsOut, surfaceOut, horizonOut));
    arcSum = ltcAddArcs(arcs, arcSum, ltcBeginArcs(arcs, horizonIn, horizonOut), cutsPiece);
    bool isMost = (keepsBoth || horizon.plane.z >= 0.0) && (keepsNone || surface.plane.z >= 0.0);
    float sum = ltcArcIntegral(arcs, arcSum, isMost, 2e-6);

    // The closing edges; where one of the surface's crossings is kept they meet on the line that both planes share.
    float corner = (slope.y > 0.0) == keepsOut ? 1.0 : -1.0;
    float cosine = keepsBoth ? ltcCosineBetween(arcs, surfaceIn, surfaceOut)
                             : corner * (keepsOut ? surfaceOutDirection.y : surfaceInDirection.y);
    float sine = keepsBoth ? surface.chord * cone.volume * surfaceIn.inverse * surfaceOut.inverse
                           : abs(keepsOut ? alongOut : alongIn);
    float surfaceAngle = ltcAngleOf(cosine, sine);
    bool isPair = keepsIn == keepsOut;
    cosine = isPair ? ltcCosineBetween(arcs, horizonIn, horizonOut)
                    : corner * (keepsOut ? horizonInDirection.y : horizonOutDirection.y);
    sine = isPair ? horizon.chord * cone.volume * horizonIn.inverse * horizonOut.inverse
                  : abs(keepsOut ? horizonInDirection.x : horizonOutDirection.x);
    float horizonAngle = ltcAngleOf(cosine, sine);
    sum += keepsNone ? 0.0 : lobe.surfaceZ * surfaceAngle;
    sum += keepsBoth && !cutsPiece ? 0.0 : horizonAngle;

    const float kInverse2Pi = 0.159154943;
    return keepsNone && !topIsAbove ? 0.0 : kInverse2Pi * lobe.weight * sum;
}

/// The form factor for `lobe` of light from everywhere above the surface.
float ltcFullFactor(LtcLobe lobe) { return lobe.weight * (0.5 + 0.5 * lobe.surfaceZ); }
