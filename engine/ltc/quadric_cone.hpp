// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace polylume::ltc {

/// A point of a cone's outline by the cosine and sine of half its angle t. Either sign means the
/// same point. What keeps the cone but takes other vectors for it turns and stretches this pair
/// linearly, so no digits get lost where a cone is all but flat or passes all but through the
/// origin.
struct HalfAngle {
    double cosine = 1.0;
    double sine = 0.0;
};

HalfAngle normalized(const HalfAngle& angle);

/// |a| |b| times the cosine and the sine of (t_b - t_a) / 2.
double dot(const HalfAngle& a, const HalfAngle& b);
double cross(const HalfAngle& a, const HalfAngle& b);

/// The cone of directions r(t) = center + axisX cos t + axisY sin t. It turns with t right-handed
/// about the directions that it holds where center . (axisX x axisY) > 0. The axes need not be at
/// right angles to each other or to the center.
struct QuadricCone {
    glm::dvec3 center;
    glm::dvec3 axisX;
    glm::dvec3 axisY;

    /// r(t) - center, for a normalized `angle`.
    glm::dvec3 offset(const HalfAngle& angle) const;
};

/// A stretch of a cone's outline, counter-clockwise from `first` to `last`: 0 to 2 pi of t. The
/// signs are such that cross(first, last) is not negative; last = -first is the whole turn.
struct ConeArc {
    HalfAngle first{1.0, 0.0};
    HalfAngle last{-1.0, 0.0};
};

/// The same cone with axes at right angles to each other and to the center. So described, what is
/// computed of a cone whose outline all but passes through the origin fits together.
QuadricCone orthogonalized(QuadricCone cone);

bool isInside(const ConeArc& arc, const HalfAngle& angle);

/// Where a cone's outline comes into the half-space normal . r >= 0 and where it goes out, and the
/// middle between the two outside of it.
struct HorizonCrossings {
    HalfAngle entering;
    HalfAngle leaving;
    HalfAngle lowest;
    HalfAngle highest;
};

/// None where the outline is on one side of the plane, or touches it.
std::optional<HorizonCrossings> crossings(const QuadricCone& cone, const glm::dvec3& normal);

/// Sum over `arcs` of the integral of (r x r') / |r|^2 dt, its z component: what the arcs give to
/// 2 pi times the clamped cosine's integral (Stokes; Lambert 1760). In closed form for the axes of
/// the cone (Heitz and Hill 2017), which are found to the last digits. Finite for any finite input.
double arcIntegral(const QuadricCone& cone, std::span<const ConeArc> arcs);

/// The same less that of the planes through the arcs' ends and the origin, each from where its arc
/// begins: what the arcs bulge out by, to the last digits, however small. None for cones wider than
/// a tenth of their height.
std::optional<double> bulgeIntegral(const QuadricCone& cone, std::span<const ConeArc> arcs);

/// atan(sqrt(w)) / sqrt(w) - 1, and of atanh for negative w; for |w| up to 0.1.
double arcTangentTail(double w);

}  // namespace polylume::ltc
