// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/sphere.glsl"

// A tube with round caps. From outside one sees the convex hull of the cones of its two end spheres: the two planes
// through the point that touch both spheres touch the tube along two lines that are parallel to its axis, and the ends
// are arcs of the spheres' outlines. Looking into the tube's direction within its radius one sees the nearer sphere
// alone.
//
// A tube that is thin for the eye is a strip that faces the point: of its four pieces of outline nothing would be left
// but rounding. Its integral along the axis has a closed form (Heitz and Hill 2017, line lights), clipped along it.

/// A tube in the shading frame, relative to the shaded point.
struct LtcTube {
    vec3 start;       ///< Centre of the first end sphere.
    vec3 end;
    vec3 axis;        ///< end - start.
    vec3 direction;   ///< Of the axis, unit.
    vec3 across;      ///< Radius times the unit vector at right angles to the axis and to the direction to it.
    vec3 offsetLow;   ///< From the axis to the line of contact on the side against `across`,
    vec3 offsetHigh;  ///< and on its side.
    float radius;
    float distance;   ///< Of the axis' line from the point.
    bool isStartNear; ///< The point lies before the start or
    bool isEndNear;   ///< beyond the end of the tube,
    bool isEndOn;     ///< and within its radius.
    bool isInside;
};

/// A tube from `start` to `start + axis`, relative to the point and in the shading frame.
LtcTube ltcTube(vec3 start, vec3 axis, float radius) {
    LtcTube tube;
    // Sizes about 1: products of them stay in range.
    float unit = inversesqrt(max(dot(start, start) + dot(axis, axis) + radius * radius, 1e-30));
    tube.start = unit * start;
    tube.axis = unit * axis;
    tube.end = tube.start + tube.axis;
    tube.radius = unit * radius;
    float square = dot(tube.axis, tube.axis);
    // A tube of no length has any direction that does not point at the point.
    vec3 other = abs(start.x) < abs(start.z) ? vec3(start.y, -start.x, 0.0) : vec3(0.0, start.z, -start.y);
    other = abs(start.x) < abs(start.z) ? vec3(start.z, 0.0, -start.x) : vec3(start.y, -start.x, 0.0);
    vec3 along = square > 1e-18 ? tube.axis : other;
    tube.direction = along * inversesqrt(max(dot(along, along), 1e-36));
    float startAlong = dot(tube.start, tube.direction);
    float endAlong = dot(tube.end, tube.direction);
    // By the nearer end, which has more digits.
    bool byStart = abs(startAlong) < abs(endAlong);
    vec3 toLine = (byStart ? tube.start : tube.end) - (byStart ? startAlong : endAlong) * tube.direction;
    float lineSquare = dot(toLine, toLine);
    // A point on the line has any direction across.
    vec3 aside = abs(tube.direction.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    toLine = lineSquare > 1e-14 ? toLine : 1e-7 * cross(tube.direction, aside);
    lineSquare = dot(toLine, toLine);
    float inverse = inversesqrt(lineSquare);
    vec3 facing = toLine * inverse;
    tube.isStartNear = startAlong > 0.0;
    tube.isEndNear = endAlong < 0.0;
    bool isBeyond = tube.isStartNear || tube.isEndNear;
    // Beside the tube the lines of contact keep off the point itself.
    float gap = isBeyond ? 0.0 : max(1.000001 * tube.radius - lineSquare * inverse, 0.0);
    tube.start += gap * facing;
    tube.end += gap * facing;
    tube.distance = lineSquare * inverse + gap;
    inverse = 1.0 / tube.distance;
    tube.isEndOn = isBeyond && tube.distance <= tube.radius;
    vec3 side = cross(facing, tube.direction);
    tube.across = tube.radius * side;
    float sine = min(tube.radius * inverse, 1.0);
    float cosine = sqrt(max((tube.distance - tube.radius) * (tube.distance + tube.radius), 0.0)) * inverse;
    tube.offsetLow = -tube.radius * (sine * facing + cosine * side);
    tube.offsetHigh = -tube.radius * (sine * facing - cosine * side);
    // End-on the nearer sphere is all there is, and the two lines are one point, anywhere on its outline: at its top.
    vec3 near = tube.isStartNear ? tube.start : tube.end;
    LtcEllipse disk = ltcEllipseOfSphere(near, tube.radius);
    vec3 single = disk.center + disk.halfAxisX - near;
    tube.offsetLow = tube.isEndOn ? single : tube.offsetLow;
    tube.offsetHigh = tube.isEndOn ? single : tube.offsetHigh;
    tube.start = tube.isEndOn ? near : tube.start;
    tube.end = tube.isEndOn ? near : tube.end;
    tube.axis = tube.isEndOn ? vec3(0.0) : tube.axis;
    float squareNear = isBeyond ? dot(near, near) : lineSquare;
    tube.isInside = squareNear < tube.radius * tube.radius;
    return tube;
}
