// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/tube_outline.glsl"

vec3 ltcTimes(LtcLobe lobe, vec3 v) {
    return vec3(lobe.m11 * v.x + lobe.m13 * v.z, v.y, lobe.m31 * v.x + lobe.m33 * v.z);
}

/// The form factor of the strip that a thin tube is for the lobe, and how thin that is: the square of half its width
/// as an angle after M^-1, about.
float ltcStripFactor(LtcTube tube, LtcLobe lobe, out float squareWidth) {
    vec3 start = ltcTimes(lobe, tube.start);
    vec3 end = ltcTimes(lobe, tube.end);
    vec3 along = ltcTimes(lobe, tube.direction);
    vec3 across = ltcTimes(lobe, tube.across);
    // Straight ends instead of the round ones, of the same area.
    float length = sqrt(dot(tube.axis, tube.axis));
    float extension = 0.785398163 * tube.radius / max(tube.distance, 1e-12);
    vec2 limits = vec2(-extension * sqrt(dot(tube.start, tube.start)),
                       length + extension * sqrt(dot(tube.end, tube.end)));

    float squareAlong = max(dot(along, along), 1e-36);
    // Of the plane that holds the axis, as normals transform: a product of two stretched vectors would lose its digits.
    float det = lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31;
    vec3 side = tube.across * (tube.distance / tube.radius);
    vec3 normal = vec3(lobe.m33 * side.x - lobe.m31 * side.z, det * side.y, lobe.m11 * side.z - lobe.m13 * side.x);
    float squareNormal = max(dot(normal, normal), 1e-36);
    vec3 width = cross(across, along);
    float nearest = max(min(dot(start, start), dot(end, end)), 1e-36);
    float cap = max(limits.y - length, -limits.x);
    squareWidth = max(dot(width, width) / squareNormal, (dot(across, across) + cap * cap * squareAlong) / nearest);

    // Clipped at both horizons.
    float crossing = -start.z / (abs(along.z) > 1e-30 ? along.z : 1e-30);
    vec2 range = limits;
    range.x = along.z > 0.0 ? max(range.x, crossing) : range.x;
    range.y = along.z < 0.0 ? min(range.y, crossing) : range.y;
    range.y = along.z == 0.0 && start.z < 0.0 ? range.x : range.y;
    crossing = -tube.start.z / (abs(tube.direction.z) > 1e-30 ? tube.direction.z : 1e-30);
    range.x = tube.direction.z > 0.0 ? max(range.x, crossing) : range.x;
    range.y = tube.direction.z < 0.0 ? min(range.y, crossing) : range.y;
    range.y = tube.direction.z == 0.0 && tube.start.z < 0.0 ? range.x : range.y;
    range.y = max(range.x, range.y);

    // The integral of z / |r|^4 along r = foot + l along, which has a height of foot.z + l along.z.
    float shift = dot(start, along) / squareAlong;
    vec3 foot = cross(along, normal) / squareAlong;
    vec2 l = range + shift;
    float squareFoot = squareNormal / squareAlong;
    vec2 squares = squareFoot + squareAlong * l * l;
    float span = range.y - range.x;
    float inverse = 1.0 / max(squares.x * squares.y, 1e-37);
    float product = squareAlong * l.x * l.y;
    float root = sqrt(squareNormal);
    float cosine = (squareFoot + product) * sqrt(inverse);
    float angle = ltcAngleOf(cosine, root * span * sqrt(inverse));
    float integral = foot.z / (2.0 * squareFoot) * (span * (squareFoot - product) * inverse + angle / root) +
                     along.z * span * (l.x + l.y) * 0.5 * inverse;
    return lobe.weight * 0.636619772 * det * tube.radius * tube.distance * max(integral, 0.0);
}
