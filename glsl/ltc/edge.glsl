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

/// The angle between `a` and `b`, neither of them unit: w(y) |a - b| of the unit vectors. For edges whose plane is known:
/// right up to opposite directions, where a cross product has no digits left.
float ltcAngle(vec3 a, vec3 b) {
    vec3 unitA = a * inversesqrt(max(dot(a, a), 1e-30));
    vec3 unitB = b * inversesqrt(max(dot(b, b), 1e-30));
    vec3 sum = unitA + unitB;
    vec3 difference = unitA - unitB;
    return ltcHalfAngleRatio(min(0.5 * sqrt(dot(sum, sum)), 1.0)) * sqrt(dot(difference, difference));
}

/// atan(x) for x from 0 to 1: x times the minimax fit in x^2 for the relative error (1e-7).
float ltcArctan(float x) {
    float u = x * x;
    float ratio = -0.00469327594;
    ratio = ratio * u + 0.024252403;
    ratio = ratio * u - 0.0594863932;
    ratio = ratio * u + 0.0991429285;
    ratio = ratio * u - 0.140194809;
    ratio = ratio * u + 0.199697239;
    ratio = ratio * u - 0.333319907;
    ratio = ratio * u + 0.999999901;
    return ratio * x;
}

/// theta * n.z of an edge from its cross product's length and z, and from its dot product: theta has the digits of the one
/// at 0 and pi and of the other between, and one division does for theta's tangent and for n.z.
float ltcSpan(float crossLength, float crossZ, float product) {
    // The floor keeps edges of no length, and those through the origin, finite; the z of their products is zero.
    float sine = max(crossLength, 3e-19);
    float cosine = abs(product);
    bool isSteep = sine > cosine;
    float greater = isSteep ? sine : cosine;
    float lesser = isSteep ? cosine : sine;
    float inverse = 1.0 / (sine * greater);
    float angle = ltcArctan(lesser * sine * inverse);
    angle = isSteep ? 1.57079633 - angle : angle;
    angle = product < 0.0 ? 3.14159265 - angle : angle;
    return angle * (crossZ * (greater * inverse));
}

/// theta * n.z of the edge from `a` to `b`, neither of them unit, where `crossZ` is the z of a x b. The caller computes
/// it from a vertex and the edge's own vector, since a difference of two far points has lost its digits.
float ltcEdgeIntegral(vec3 a, vec3 b, float crossZ) {
    vec2 crossXY = vec2(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z);
    return ltcSpan(sqrt(dot(crossXY, crossXY) + crossZ * crossZ), crossZ, dot(a, b));
}

/// The angle from `a` to `b` in their plane, neither of them unit: positive where it turns counter-clockwise. `turn` is its
/// sign, 1 or -1, which near opposite directions the two no longer tell.
float ltcPlaneAngle(vec2 a, vec2 b, float turn) {
    float crossZ = a.x * b.y - a.y * b.x;
    float product = dot(a, b);
    float sine = abs(crossZ);
    float cosine = abs(product);
    bool isSteep = sine > cosine;
    float greater = isSteep ? sine : cosine;
    float lesser = isSteep ? cosine : sine;
    float narrow = ltcArctan(lesser / max(greater, 1e-37));
    narrow = isSteep ? 1.57079633 - narrow : narrow;
    narrow = crossZ < 0.0 ? -narrow : narrow;
    return product < 0.0 ? turn * 3.14159265 - narrow : narrow;
}

/// `v` moved onto the plane z = 0 where it is a millionth of its length off, as rounding leaves it. Points that lie on a
/// horizon then are on one side of it all, and no outline seems to cross it more often than it does.
vec3 ltcSnapToHorizon(vec3 v) {
    v.z = v.z * v.z > 5e-13 * (v.x * v.x + v.y * v.y) ? v.z : 0.0;
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
