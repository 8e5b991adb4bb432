// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

// Shapes as seen from the origin, sampled evenly by solid angle. Triangle and rectangle lose digits
// to cancellation for solid angles far below a millionth.
namespace polylume::reference {

/// A triangle (Arvo 1995).
class SphericalTriangle {
  public:
    /// Of any orientation; the vertices need not be unit.
    SphericalTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

    /// In steradians; 0 for a triangle that is degenerate.
    double solidAngle() const { return solidAngle_; }

    /// A unit direction, from `random` in [0, 1]^2.
    glm::dvec3 sample(const glm::dvec2& random) const;

  private:
    glm::dvec3 a_, b_, c_;
    glm::dvec3 towardC_;  ///< Unit, in the plane of a and c, perpendicular to a.
    double cosC_ = 1.0;   ///< Of the side from a to b.
    double sineA_ = 0.0, cosineA_ = 1.0, angleA_ = 0.0;
    double solidAngle_ = 0.0;
};

/// A rectangle (Urena, Fajardo and King 2013).
class SphericalRectangle {
  public:
    /// The rectangle corner + s edgeX + t edgeY, 0 <= s, t <= 1, with edges at right angles.
    SphericalRectangle(const glm::dvec3& corner, const glm::dvec3& edgeX, const glm::dvec3& edgeY);

    double solidAngle() const { return solidAngle_; }
    /// A point of the rectangle, seen in a direction of even density, from `random` in [0, 1]^2.
    glm::dvec3 sample(const glm::dvec2& random) const;

  private:
    glm::dvec3 x_, y_, z_;  ///< Unit axes, z away from the rectangle.
    double x0_, x1_, y0_, y1_, z0_;
    double b0_, b1_, k_;  ///< n0, n2 and 2 pi - g2 - g3 of the paper.
    double solidAngle_ = 0.0;
};

/// All directions within an angle of at most pi/2 of an axis; small ones keep their digits.
class SphericalCap {
  public:
    /// `axis` unit; the angle by its sine and cosine.
    SphericalCap(const glm::dvec3& axis, double sine, double cosine);

    double solidAngle() const { return solidAngle_; }
    /// A unit direction, from `random` in [0, 1]^2.
    glm::dvec3 sample(const glm::dvec2& random) const;

  private:
    glm::dvec3 axis_, x_, y_;
    double height_;  ///< 1 - cosine.
    double solidAngle_;
};

/// The directions cos b (cos a x + sin a y) + sin b z with a from `first` to `last` and |sin b| up
/// to `sine`: as even as a and sin b are (Archimedes). Small and narrow ones keep their digits.
class SphericalBand {
  public:
    /// Axes unit, at right angles.
    SphericalBand(const glm::dmat3& axes, double first, double last, double sine);

    double solidAngle() const { return 2.0 * sine_ * (last_ - first_); }
    /// A unit direction, from `random` in [0, 1]^2.
    glm::dvec3 sample(const glm::dvec2& random) const;

  private:
    glm::dmat3 axes_;
    double first_, last_, sine_;
};

/// The solid angle of a triangle (van Oosterom and Strackee 1983, eq. 8), not negative.
double triangleSolidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

}  // namespace polylume::reference
