// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/spherical_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/plane_axes.hpp"

namespace polylume::reference {
namespace {

constexpr double kPi = std::numbers::pi;

double safeAcos(double cosine) {
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

double safeRoot(double square) {
    return std::sqrt(std::max(square, 0.0));
}

}  // namespace

double triangleSolidAngle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const double lengthA = glm::length(a), lengthB = glm::length(b), lengthC = glm::length(c);
    const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
    const double rest = lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC +
                        glm::dot(b, c) * lengthA + glm::dot(c, a) * lengthB;
    return 2.0 * std::atan2(volume, rest);
}

SphericalTriangle::SphericalTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
    : a_(glm::normalize(a)), b_(glm::normalize(b)), c_(glm::normalize(c)) {
    const glm::dvec3 normalC = glm::cross(a_, b_);
    const glm::dvec3 normalB = glm::cross(a_, c_);
    const glm::dvec3 toward = c_ - glm::dot(c_, a_) * a_;
    const double length = glm::length(toward);
    const double sine = glm::length(glm::cross(normalC, normalB));
    if (!(length > 0.0) || !(sine > 0.0)) return;
    towardC_ = toward / length;
    cosC_ = glm::dot(a_, b_);
    angleA_ = std::atan2(sine, glm::dot(normalC, normalB));
    sineA_ = std::sin(angleA_);
    cosineA_ = std::cos(angleA_);
    solidAngle_ = triangleSolidAngle(a_, b_, c_);
}

glm::dvec3 SphericalTriangle::sample(const glm::dvec2& random) const {
    // The point C' on the side from A to C that cuts off the share random.x of the area: the cosine
    // q of its distance from A (Arvo 1995, section 3).
    const double phi = random.x * solidAngle_ - angleA_;
    const double s = std::sin(phi), t = std::cos(phi);
    const double u = t - cosineA_;
    const double v = s + sineA_ * cosC_;
    const double denominator = (v * s + u * t) * sineA_;
    const double q = denominator != 0.0
                         ? std::clamp(((v * t - u * s) * cosineA_ - v) / denominator, -1.0, 1.0)
                         : 1.0;
    const glm::dvec3 cut = q * a_ + safeRoot(1.0 - q * q) * towardC_;
    // A point on the arc from B to C', even in the height above B.
    const double height = 1.0 - random.y * (1.0 - glm::dot(cut, b_));
    const glm::dvec3 toward = cut - glm::dot(cut, b_) * b_;
    const double length = glm::length(toward);
    if (!(length > 0.0)) return b_;
    return height * b_ + safeRoot(1.0 - height * height) / length * toward;
}

SphericalRectangle::SphericalRectangle(const glm::dvec3& corner, const glm::dvec3& edgeX,
                                       const glm::dvec3& edgeY) {
    const double width = glm::length(edgeX), height = glm::length(edgeY);
    x_ = edgeX / width;
    y_ = edgeY / height;
    z_ = glm::cross(x_, y_);
    z0_ = glm::dot(corner, z_);
    if (z0_ > 0.0) {
        z_ = -z_;
        z0_ = -z0_;
    }
    x0_ = glm::dot(corner, x_);
    y0_ = glm::dot(corner, y_);
    x1_ = x0_ + width;
    y1_ = y0_ + height;
    // z of the normals of the four planes through the origin and an edge, and the angles between
    // them.
    const double n0 = -y0_ / std::hypot(y0_, z0_), n1 = x1_ / std::hypot(x1_, z0_);
    const double n2 = y1_ / std::hypot(y1_, z0_), n3 = -x0_ / std::hypot(x0_, z0_);
    const double g0 = safeAcos(-n0 * n1), g1 = safeAcos(-n1 * n2);
    const double g2 = safeAcos(-n2 * n3), g3 = safeAcos(-n3 * n0);
    b0_ = n0;
    b1_ = n2;
    k_ = 2.0 * kPi - g2 - g3;
    const double sum = g0 + g1 - k_;
    solidAngle_ = z0_ < 0.0 && sum > 0.0 ? sum : 0.0;
}

glm::dvec3 SphericalRectangle::sample(const glm::dvec2& random) const {
    // The column x that has the share random.x of the solid angle to its left.
    const double angle = random.x * solidAngle_ + k_;
    const double sine = std::sin(angle);
    // Both are 0 at the left end of a rectangle that fills half of all directions.
    const double top = std::cos(angle) * b0_ - b1_;
    const double f = sine != 0.0 || top != 0.0 ? top / sine : 0.0;
    const double c = std::clamp(std::copysign(1.0, f) / std::sqrt(f * f + b0_ * b0_), -1.0, 1.0);
    const double x = std::clamp(-c * z0_ / std::max(safeRoot(1.0 - c * c), 1e-300), x0_, x1_);
    // Along the column the density is even in the sine of the angle to the plane y = 0.
    const double square = x * x + z0_ * z0_;
    const double h0 = y0_ / std::sqrt(square + y0_ * y0_);
    const double h1 = y1_ / std::sqrt(square + y1_ * y1_);
    const double h = h0 + random.y * (h1 - h0);
    const double rest = 1.0 - h * h;
    const double y = rest > 1e-15 ? std::clamp(h * std::sqrt(square / rest), y0_, y1_)
                     : h < 0.0    ? y0_
                                  : y1_;
    return x * x_ + y * y_ + z0_ * z_;
}

SphericalCap::SphericalCap(const glm::dvec3& axis, double sine, double cosine)
    : axis_(axis),
      x_(perpendicularTo(axis)),
      y_(glm::cross(axis, x_)),
      height_(sine * sine / (1.0 + cosine)),
      solidAngle_(2.0 * kPi * height_) {}

glm::dvec3 SphericalCap::sample(const glm::dvec2& random) const {
    const double below = random.x * height_;  // 1 - the cosine to the axis.
    const double sine = safeRoot(below * (2.0 - below));
    const double azimuth = 2.0 * kPi * random.y;
    return (1.0 - below) * axis_ + sine * (std::cos(azimuth) * x_ + std::sin(azimuth) * y_);
}

SphericalBand::SphericalBand(const glm::dmat3& axes, double first, double last, double sine)
    : axes_(axes), first_(first), last_(last), sine_(sine) {}

glm::dvec3 SphericalBand::sample(const glm::dvec2& random) const {
    const double azimuth = first_ + random.x * (last_ - first_);
    const double height = sine_ * (2.0 * random.y - 1.0);
    const double radius = safeRoot(1.0 - height * height);
    return axes_ * glm::dvec3(radius * std::cos(azimuth), radius * std::sin(azimuth), height);
}

}  // namespace polylume::reference
