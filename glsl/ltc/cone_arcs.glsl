// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/cone_section.glsl"
#include "ltc/edge.glsl"

// Arcs of a cone's outline, without branches.
//
// The integral over the cone is the sum over its outline of (r x r')_z / |r|^2 dt (Lambert 1760; Baum et al. 1989, eq.
// 1). Along an arc each of the three components in e1, e2, e3 is the one of r0 x r1 / (|r0| |r1|) times an angle over
// its sine, as it is along a straight edge; only that the three angles differ, and that the first is a hyperbolic one.

/// What arcs of one cone share.
struct LtcConeArcs {
    vec3 squares;
    float p;  ///< Roots of A^2 + C^2,
    float q;  ///< B^2 + C^2
    float d;  ///< and A^2 - B^2.
    float squareD;
    vec3 weights;  ///< z of b x c, c x a, a x b.
};

LtcConeArcs ltcConeArcs(LtcCone cone) {
    LtcConeArcs arcs;
    arcs.squares = cone.squares;
    arcs.squareD = max(cone.squares.x - cone.squares.y, 0.0);
    arcs.p = sqrt(cone.squares.x + cone.squares.z);
    arcs.q = sqrt(cone.squares.y + cone.squares.z);
    arcs.d = sqrt(arcs.squareD);
    arcs.weights = vec3(ltcCrossZ(cone.b, cone.c), ltcCrossZ(cone.c, cone.a), ltcCrossZ(cone.a, cone.b));
    return arcs;
}

/// A point of the outline: cosine and sine of t, and the inverse length of its vector.
struct LtcConePoint {
    vec2 point;
    float inverse;
};

LtcConePoint ltcConePoint(LtcConeArcs arcs, vec2 point) {
    float square = arcs.squares.x * point.x * point.x + arcs.squares.y * point.y * point.y + arcs.squares.z;
    return LtcConePoint(point, inversesqrt(max(square, 1e-36)));
}

LtcConePoint ltcSelect(bool condition, LtcConePoint first, LtcConePoint second) {
    return LtcConePoint(condition ? first.point : second.point, condition ? first.inverse : second.inverse);
}

/// The three angles of arcs, of which ends count as positive and starts as negative: as products of numbers of length
/// 1, complex ones and hyperbolic ones. The sines of the last two lack their factor d, which may be 0.
struct LtcArcSum {
    vec2 turn;
    vec2 lean;
    vec2 growth;
    vec2 exponential;  ///< The growth's exponential as numerator and denominator, for the large ones.
};

LtcArcSum ltcBeginArcs(LtcConeArcs arcs, LtcConePoint first, LtcConePoint last) {
    float inverses = first.inverse * last.inverse;
    vec2 step = last.point - first.point;
    vec2 cross01 = vec2(first.point.x * last.point.y - first.point.y * last.point.x, 0.0);
    LtcArcSum sum;
    float squareP = arcs.p * arcs.p;
    float squareQ = arcs.q * arcs.q;
    sum.turn = inverses * vec2(squareP * first.point.x * last.point.x + squareQ * first.point.y * last.point.y,
                               arcs.p * arcs.q * cross01.x);
    sum.lean = inverses * vec2(squareQ + arcs.squareD * first.point.x * last.point.x, arcs.q * step.x);
    sum.growth = inverses * vec2(squareP - arcs.squareD * first.point.y * last.point.y, arcs.p * step.y);
    float last1 = (arcs.p + arcs.d * abs(last.point.y)) * last.inverse;
    float first1 = (arcs.p + arcs.d * abs(first.point.y)) * first.inverse;
    sum.exponential = vec2((last.point.y >= 0.0 ? last1 : 1.0) * (first.point.y < 0.0 ? first1 : 1.0),
                           (last.point.y < 0.0 ? last1 : 1.0) * (first.point.y >= 0.0 ? first1 : 1.0));
    return sum;
}

/// Adds the arcs of `other` where `condition` is true.
LtcArcSum ltcAddArcs(LtcConeArcs arcs, LtcArcSum sum, LtcArcSum other, bool condition) {
    LtcArcSum both;
    both.turn = vec2(sum.turn.x * other.turn.x - sum.turn.y * other.turn.y,
                     sum.turn.x * other.turn.y + sum.turn.y * other.turn.x);
    both.lean = vec2(sum.lean.x * other.lean.x - arcs.squareD * sum.lean.y * other.lean.y,
                     sum.lean.x * other.lean.y + sum.lean.y * other.lean.x);
    both.growth = vec2(sum.growth.x * other.growth.x + arcs.squareD * sum.growth.y * other.growth.y,
                       sum.growth.x * other.growth.y + sum.growth.y * other.growth.x);
    both.exponential = sum.exponential * other.exponential;
    both.turn = condition ? both.turn : sum.turn;
    both.lean = condition ? both.lean : sum.lean;
    both.growth = condition ? both.growth : sum.growth;
    both.exponential = condition ? both.exponential : sum.exponential;
    return both;
}

/// The angle from 0 to pi of a cosine and of a sine >= 0, with the digits of the sine at both ends.
float ltcAngleOf(float cosine, float sine) {
    float narrow = ltcHalfAngleRatio(min(abs(cosine), 1.0)) * sine;
    return cosine < 0.0 ? 3.14159265 - narrow : narrow;
}

/// z of the integral along the arcs. `isMost` decides between nothing and all of the outline where they are within the
/// angle `open` of both.
float ltcArcIntegral(LtcConeArcs arcs, LtcArcSum sum, bool isMost, float open) {
    // About the cone's axis, 0 to 2 pi.
    float angle = ltcAngleOf(sum.turn.x, abs(sum.turn.y));
    angle = sum.turn.y < 0.0 ? -angle : angle;
    bool isReflex = abs(sum.turn.y) > open || sum.turn.x < 0.0 ? sum.turn.y < 0.0 : isMost;
    angle += isReflex ? 6.28318531 : 0.0;

    float lean = ltcHalfAngleRatio(min(abs(sum.lean.x), 1.0)) * sum.lean.y;
    float inverseD = 1.0 / max(arcs.d, 1e-18);
    float straight = 3.14159265 * inverseD;
    lean = sum.lean.x < 0.0 ? (sum.lean.y < 0.0 ? -straight : straight) - lean : lean;

    float square = arcs.squareD * sum.growth.y * sum.growth.y;
    // The series of asinh(s) / s, within 1e-7 where it is used.
    float series = -0.0139648438;
    series = 0.0173527644 + square * series;
    series = -0.0223721591 + square * series;
    series = 0.0303819444 + square * series;
    series = -0.0446428571 + square * series;
    series = 0.075 + square * series;
    series = -0.166666667 + square * series;
    series = 1.0 + square * series;
    float growth = square < 0.16 && arcs.squareD < 0.5 * arcs.p * arcs.p
                       ? sum.growth.y * series
                       : log(sum.exponential.x / sum.exponential.y) * inverseD;

    return (arcs.weights.z * angle + arcs.weights.y * lean * arcs.p - arcs.weights.x * growth * arcs.q) /
           max(arcs.p * arcs.q, 1e-36);
}

/// The unit direction to a point of the outline, in the frame of the cone.
vec3 ltcConeDirection(LtcCone cone, LtcConePoint p) {
    return (cone.a * p.point.x + cone.b * p.point.y + cone.c) * p.inverse;
}

/// Cosine of the angle between two points of the outline.
float ltcCosineBetween(LtcConeArcs arcs, LtcConePoint first, LtcConePoint last) {
    return first.inverse * last.inverse *
           (arcs.squares.x * first.point.x * last.point.x + arcs.squares.y * first.point.y * last.point.y +
            arcs.squares.z);
}
