// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ltc/lobe.hpp"
#include "ltc/quadric_cone.hpp"

namespace polylume::ltc {

/// A corner of an outline, relative to the shaded point. Its offset from a place at the light, the
/// same for all corners, has the digits of differences of two corners.
struct OutlineCorner {
    glm::dvec3 position;
    glm::dvec3 offset;
};

/// A stretch of an outline: an arc of one of its cones or, with no cone, a straight edge.
struct OutlinePiece {
    static constexpr int kStraight = -1;

    OutlineCorner start;
    OutlineCorner end;
    int cone = kStraight;
    ConeArc arc{};
    /// Of a straight edge: of the plane through it and the origin, about which it turns
    /// right-handed,
    glm::dvec3 normal{0.0};
    double weight = 0.0;  ///< and z of its unit normal after M^-1.
};

/// A half-space normal . r >= 0.
struct HalfSpace {
    glm::dvec3 normal;
    double weight;  ///< z of its normal after M^-1, unit.
};

/// The outline of a convex set of directions in the shading frame. It turns right-handed about
/// them: counter-clockwise as seen from the light.
struct RoundOutline {
    std::array<QuadricCone, 2> cones{};
    std::vector<OutlinePiece> pieces;
    /// Of the cones' centers to that place at the light.
    std::array<glm::dvec3, 2> centerOffsets{};

    /// A whole turn of the first cone.
    static RoundOutline ofCone(const QuadricCone& cone);

    /// Adds a straight edge of up to about half a turn: as two, where it is long enough for its
    /// ends not to tell the way between them, or on which side of a plane that is.
    void addEdge(const OutlineCorner& start, const OutlineCorner& end, const glm::dvec3& normal,
                 double weight);

    OutlineCorner cornerAt(int cone, const HalfAngle& angle) const;
    OutlinePiece arcPiece(int cone, const ConeArc& arc) const;
};

/// What lies in the half-space, closed along its plane (Sutherland and Hodgman 1974). An outline
/// stays a closed loop whatever rounding makes of the crossings, so the integral's error is theirs.
RoundOutline clipped(const RoundOutline& outline, const HalfSpace& halfSpace);

/// z after M^-1 of the unit normal of a plane of this normal.
double transformedNormalZ(const glm::dvec3& normal, const Lobe& lobe);

/// Integral of the clamped cosine / pi over M^-1 of the outline's inside, which has to be above z =
/// 0.
double integrate(const RoundOutline& outline, const Lobe& lobe);

}  // namespace polylume::ltc
