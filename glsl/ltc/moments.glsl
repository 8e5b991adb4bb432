// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/edge.glsl"
#include "ltc/lobe.glsl"

// Where the light of a spherical polygon comes from: the mean of its directions, each weighted by its cosine. x and y of
// that are an axial moment of second order (Arvo 1995), whose sum over the edges needs no angles: along a great arc from a
// to b of unit normal n the integral of the direction is (b - a) x n, which is (a + b) |a x b| / (1 + a.b).

struct LtcMoments {
    float sum;   ///< As ltcFactor() takes it.
    vec2 disk;   ///< Integral of the direction's xy times its cosine, times -3.
};

LtcMoments ltcNoMoments() { return LtcMoments(0.0, vec2(0.0)); }

/// Adds the edge from `a` to `b`, neither of them unit; `crossZ` is the z of a x b.
void ltcAddMoments(vec3 a, vec3 b, float crossZ, inout LtcMoments moments) {
    // The floor only keeps a vertex at the origin finite; its cross product is zero.
    float inverseA = inversesqrt(max(dot(a, a), 1e-30));
    float inverseB = inversesqrt(max(dot(b, b), 1e-30));
    vec3 sum = inverseA * a + inverseB * b;
    // Opposite vectors: the edge passes through the origin, and its cross product is zero.
    float square = max(dot(sum, sum), 1e-14);
    float inverseLength = inversesqrt(square);
    float normalZ = (2.0 * inverseA * inverseB * inverseLength) * crossZ;
    moments.sum += ltcHalfAngleRatio(0.5 * square * inverseLength) * normalZ;
    moments.disk += (normalZ * inverseLength) * sum.xy;
}

/// Adds the arc along the horizon that closes an outline between two points of it.
void ltcAddHorizonMoments(vec2 a, vec2 b, inout LtcMoments moments) {
    moments.sum += ltcPlaneAngle(a, b, sign(a.x * b.y - a.y * b.x));
    vec2 difference = inversesqrt(max(dot(b, b), 1e-30)) * b - inversesqrt(max(dot(a, a), 1e-30)) * a;
    moments.disk += vec2(difference.y, -difference.x);
}

/// Adds the arc along the surface that closes an outline after M^-1: counter-clockwise where `turn` is 1, clockwise
/// where it is -1, none where it is 0.
void ltcAddSurfaceMoments(LtcLobe lobe, vec3 a, vec3 b, float turn, inout LtcMoments moments) {
    float inverse = inversesqrt(lobe.m11 * lobe.m11 + lobe.m31 * lobe.m31);
    vec2 normal = inverse * vec2(-lobe.m31, lobe.m11);  // Its x and z; its y is 0.
    moments.sum += normal.y * ltcPlaneAngle(ltcAlongSurface(lobe, a), ltcAlongSurface(lobe, b), turn);
    vec3 difference = inversesqrt(max(dot(b, b), 1e-30)) * b - inversesqrt(max(dot(a, a), 1e-30)) * a;
    moments.disk += (abs(turn) * normal.y) * vec2(difference.y * normal.y, difference.z * normal.x - difference.x * normal.y);
}

/// The direction above the centroid of a part of the unit disk. z >= 0.
vec3 ltcMeanDirection(LtcMoments moments) {
    float signedFloor = moments.sum > 0.0 ? 1e-25 : -1e-25;
    vec2 onDisk = clamp(moments.disk * (0.666666667 / (moments.sum + signedFloor)), -1.0, 1.0);
    return vec3(onDisk, sqrt(max(1.0 - dot(onDisk, onDisk), 0.0)));
}
