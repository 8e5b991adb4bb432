// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// The integral of a clamped cosine over a spherical polygon is a sum over its edges (Lambert 1760; Baum, Rushmeier
// and Winget 1989, eq. 1): (1 / 2 pi) sum theta_i n_i.z, theta_i the angle that edge i spans at the origin and n_i the
// unit normal of the plane through the edge and the origin.

/// z of the cross product a x b.
float ltcCrossZ(vec3 a, vec3 b) { return a.x * b.y - a.y * b.x; }

/// w(y) = acos(y) / sqrt(1 - y^2) for y from 0 to 1, where it is smooth: the minimax fit for the relative error (7e-8).
float ltcHalfAngleRatio(float y) {
    float w = 0.0174789969;
    w = w * y - 0.0972654596;
    w = w * y + 0.252086997;
    w = w * y - 0.42358312;
    w = w * y + 0.556556284;
    w = w * y - 0.660969317;
    w = w * y + 0.784880996;
    w = w * y - 0.999981523;
    w = w * y + 1.57079625;
    return w;
}

/// theta / sin(theta) for the angle between the unit vectors `a` and `b`, 0 to pi, relative error below 1e-6, no acos.
///
/// With y = cos(theta / 2) = |a + b| / 2 the half-angle formulas give theta / sin(theta) = w(y) / y. Taking y from the sum
/// of the vectors keeps the digits near theta = pi, where a dot product loses them.
float ltcThetaOverSinTheta(vec3 a, vec3 b) {
    vec3 sum = a + b;
    // Opposite vectors: the edge passes through the origin, and its cross product, a factor of the result, is zero.
    float square = max(dot(sum, sum), 1e-14);
    float inverseLength = inversesqrt(square);
    float y = 0.5 * square * inverseLength;
    return ltcHalfAngleRatio(y) * 2.0 * inverseLength;
}

/// The angle between `a` and `b`, neither of them unit: w(y) |a - b| of the unit vectors. For edges whose plane is known:
/// right up to opposite directions, where a cross product has no digits left.
float ltcAngle(vec3 a, vec3 b) {
    vec3 unitA = a * inversesqrt(max(dot(a, a), 1e-30));
    vec3 unitB = b * inversesqrt(max(dot(b, b), 1e-30));
    vec3 sum = unitA + unitB;
    vec3 difference = unitA - unitB;
    return ltcHalfAngleRatio(min(0.5 * sqrt(dot(sum, sum)), 1.0)) * sqrt(dot(difference, difference));
}

/// theta * n.z of the edge from `a` to `b`, neither of them unit, where `crossZ` is the z of a x b. The caller computes
/// it from a vertex and the edge's own vector, since a difference of two far points has lost its digits.
float ltcEdgeIntegral(vec3 a, vec3 b, float crossZ) {
    // The floor only keeps a vertex at the origin finite; its cross product is zero.
    float inverseA = inversesqrt(max(dot(a, a), 1e-30));
    float inverseB = inversesqrt(max(dot(b, b), 1e-30));
    return crossZ * inverseA * inverseB * ltcThetaOverSinTheta(a * inverseA, b * inverseB);
}

/// `v` moved onto the plane z = 0 where it is a millionth of its length off, as rounding leaves it. Points that lie on a
/// horizon then are on one side of it all, and no outline seems to cross it more often than it does.
vec3 ltcSnapToHorizon(vec3 v) {
    v.z = abs(v.z) > 1e-6 * max(abs(v.x), abs(v.y)) ? v.z : 0.0;
    return v;
}

/// What is left of an edge at z >= 0.
struct LtcClippedEdge {
    vec3 first;
    vec3 last;
    float share;  ///< Of the edge's length; 0 where nothing is left.
    bool leaves;  ///< The last point is where the edge goes below.
    bool enters;  ///< The first point is where it comes up.
};

/// Clips the edge from `a` to `b` = a + edge, whose ends have the heights `zA` and `zB`.
LtcClippedEdge ltcClipEdge(vec3 a, vec3 b, vec3 edge, float zA, float zB) {
    LtcClippedEdge clipped;
    clipped.leaves = zA >= 0.0 && zB < 0.0;
    clipped.enters = zA < 0.0 && zB >= 0.0;
    bool crosses = clipped.leaves || clipped.enters;
    float inverseRise = 1.0 / (zB - zA);
    // From the end that is nearer to the horizon: the other may be so far away that it has lost the digits.
    bool fromA = abs(zA) < abs(zB);
    vec3 base = fromA ? a : b;
    vec3 crossing = base - ((fromA ? zA : zB) * inverseRise) * edge;
    // An edge below the horizon keeps one of its points and no length.
    vec3 below = crosses ? crossing : a;
    clipped.first = zA >= 0.0 ? a : below;
    clipped.last = zB >= 0.0 ? b : below;
    clipped.share = crosses ? (max(zB, 0.0) - max(zA, 0.0)) * inverseRise : (zA >= 0.0 ? 1.0 : 0.0);
    return clipped;
}
