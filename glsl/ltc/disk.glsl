// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/ellipse.glsl"

/// The form factor for the clamped cosine, 0 to 1, of an ellipse of equal half axes. The plane through the point, the
/// centre and the normal halves its cone; in it the axis halves the angle between the two rays to the rim, so that the
/// section needs no root of a cubic equation.
float ltcDiskCosineFactor(LtcEllipse disk) {
    float squareR = max(dot(disk.halfAxisX, disk.halfAxisX), 1e-30);
    float inverseR = inversesqrt(squareR);
    // The centre seen from the foot of the point's perpendicular, along the half axes, and how far away the plane is.
    vec2 offset = inverseR * vec2(dot(disk.halfAxisX, disk.center), dot(disk.halfAxisY, disk.center));
    float squareOffset = max(dot(offset, offset), 1e-30);
    float inverseOffset = inversesqrt(squareOffset);
    float distance = squareOffset * inverseOffset;
    // Straight above the centre any direction will do.
    vec2 outward = squareOffset > 1e-30 ? inverseOffset * offset : vec2(1.0, 0.0);
    float height = disk.volume * inverseR * inverseR;
    float squareHeight = height * height;

    // `product` is that of the lengths of the two rays, (turn.x, turn.y) the shorter half axis and (-turn.y, turn.x)
    // the cone's axis, both along `outward` and the normal, their differences taken where they keep their digits.
    float radius = squareR * inverseR;
    float mid = squareHeight + (radius - distance) * (radius + distance);
    float twice = 2.0 * distance * height;
    float product = sqrt(mid * mid + twice * twice);
    vec2 turn = mid > 0.0 ? vec2(product + mid, -twice) : vec2(twice, mid - product);
    turn *= inversesqrt(max(dot(turn, turn), 1e-36));

    float excess = squareHeight + (distance - radius) * (distance + radius);
    float greater = 0.5 * (product + abs(excess));
    float less = squareR * squareHeight / max(greater, 1e-36);
    vec2 squares = excess > 0.0 ? vec2(less, greater) : vec2(greater, less);
    float sum = squareR + squareHeight + squareOffset + product;

    vec3 lengths = vec3(radius, sqrt(squares));
    vec2 rim = inverseR * vec2(disk.halfAxisX.z, disk.halfAxisY.z);
    float normalZ = inverseR * inverseR * ltcCrossZ(disk.halfAxisX, disk.halfAxisY);
    float outwardZ = dot(outward, rim);
    vec3 directionsZ = vec3(outward.y * rim.x - outward.x * rim.y, turn.x * outwardZ + turn.y * normalZ,
                            turn.x * normalZ - turn.y * outwardZ);
    LtcConeArcs arcs;
    arcs.squares = vec3(squareR, squares);
    arcs.squareD = 2.0 * squareR * squareOffset / sum;
    arcs.p = sqrt(0.5 * sum);
    arcs.q = sqrt(product);
    arcs.d = sqrt(arcs.squareD);
    arcs.weights = lengths.yzx * lengths.zxy * directionsZ;
    return ltcArcsCosineFactor(arcs, lengths * directionsZ, disk.volume);
}
