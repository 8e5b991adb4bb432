// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/quadric_cone.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace polylume::ltc {
namespace {

constexpr double kPi = std::numbers::pi;

HalfAngle negated(const HalfAngle& angle) {
    return {-angle.cosine, -angle.sine};
}

/// A change of the three vectors that keeps the cone, as it acts on half angles (of SL(2, R)).
struct Reparametrization {
    double cosineFromCosine = 1.0;
    double cosineFromSine = 0.0;
    double sineFromCosine = 0.0;
    double sineFromSine = 1.0;

    HalfAngle operator()(const HalfAngle& angle) const {
        return {cosineFromCosine * angle.cosine + cosineFromSine * angle.sine,
                sineFromCosine * angle.cosine + sineFromSine * angle.sine};
    }

    /// For a turn of the axes by twice the angle of this cosine and sine.
    void turn(double cosine, double sine) {
        *this = {cosine * cosineFromCosine + sine * sineFromCosine,
                 cosine * cosineFromSine + sine * sineFromSine,
                 cosine * sineFromCosine - sine * cosineFromCosine,
                 cosine * sineFromSine - sine * cosineFromSine};
    }

    /// For a hyperbolic rotation of center and axisX by twice `parameter`.
    void stretchX(double parameter) {
        const double factor = std::exp(parameter);
        cosineFromCosine /= factor;
        cosineFromSine /= factor;
        sineFromCosine *= factor;
        sineFromSine *= factor;
    }

    /// The same of center and axisY. Turns there and back would lose the digits of a small one.
    void stretchY(double parameter) {
        const double cosine = std::cosh(parameter);
        const double sine = std::sinh(parameter);
        *this = {cosine * cosineFromCosine - sine * sineFromCosine,
                 cosine * cosineFromSine - sine * sineFromSine,
                 cosine * sineFromCosine - sine * cosineFromCosine,
                 cosine * sineFromSine - sine * cosineFromSine};
    }
};

bool isOrthogonal(const glm::dvec3& a, const glm::dvec3& b, double product) {
    // A few roundings of a dot product.
    constexpr double kTolerance = 4e-16;
    return std::abs(product) <= kTolerance * glm::length(a) * glm::length(b);
}

/// Makes the axes orthogonal by a plane rotation of the two (Jacobi 1846, one-sided: Hestenes
/// 1958). False where they are already.
bool rotateAxes(QuadricCone& cone, Reparametrization& map) {
    glm::dvec3& a = cone.axisX;
    glm::dvec3& b = cone.axisY;
    const double product = glm::dot(a, b);
    if (isOrthogonal(a, b, product)) return false;
    // From the sum and the difference, for axes of all but equal lengths. Up to 45 degrees, so that
    // an axis that is far shorter than the other one keeps its digits.
    const double difference = glm::dot(a - b, a + b);
    const double angle =
        0.5 * std::atan2(std::copysign(2.0, difference) * product, std::abs(difference));
    const glm::dvec3 turned = a * std::cos(angle) + b * std::sin(angle);
    b = b * std::cos(angle) - a * std::sin(angle);
    a = turned;
    map.turn(std::cos(0.5 * angle), std::sin(0.5 * angle));
    return true;
}

/// Makes center and `axis` orthogonal by a hyperbolic rotation (Veselic 1993) and gives half of its
/// parameter; 0 where they are already, or where the outline passes through the origin.
double boost(glm::dvec3& center, glm::dvec3& axis) {
    const double product = glm::dot(center, axis);
    if (isOrthogonal(center, axis, product)) return 0.0;
    const glm::dvec3 sum = center + axis;
    const glm::dvec3 difference = center - axis;
    const double sumLength = glm::length(sum);
    const double differenceLength = glm::length(difference);
    if (!(sumLength > 0.0) || !(differenceLength > 0.0)) return 0.0;
    // The outline's two points on the axis, center +- axis, get to the same distance.
    const double factor = std::sqrt(differenceLength / sumLength);
    if (factor > 0.5 && factor < 2.0) {
        // The same with all digits of an axis that is far shorter than the center.
        const double parameter = 0.25 * std::log1p(-4.0 * product / (sumLength * sumLength));
        const glm::dvec3 old = center;
        center = old * std::cosh(parameter) + axis * std::sinh(parameter);
        axis = axis * std::cosh(parameter) + old * std::sinh(parameter);
        return 0.5 * parameter;
    }
    center = 0.5 * (sum * factor + difference / factor);
    axis = 0.5 * (sum * factor - difference / factor);
    return 0.5 * std::log(factor);
}

/// Other vectors for the same cone, at right angles to each other, the second axis the longer one:
/// where a long cone comes close to the origin the half angle is then all but 0 or 180 degrees,
/// where it has digits for any length.
Reparametrization orthogonalize(QuadricCone& cone) {
    // Convergence is quadratic. Few cones need ten sweeps: those that pass the origin closely.
    constexpr int kMaxSweepCount = 60;
    Reparametrization map;
    for (int sweep = 0; sweep < kMaxSweepCount; ++sweep) {
        bool changed = rotateAxes(cone, map);
        const double parameterX = boost(cone.center, cone.axisX);
        map.stretchX(parameterX);
        const double parameterY = boost(cone.center, cone.axisY);
        map.stretchY(parameterY);
        changed = changed || parameterX != 0.0 || parameterY != 0.0;
        if (!changed) break;
    }
    if (glm::dot(cone.axisX, cone.axisX) > glm::dot(cone.axisY, cone.axisY)) {
        cone.axisX = std::exchange(cone.axisY, -cone.axisX);
        map.turn(std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0);
    }
    return map;
}

/// r(t) = lengthX cos t e_x + lengthY sin t e_y + height e_z, lengthX <= lengthY, and the z
/// components of the right-handed orthonormal e's.
struct ConeAxes {
    double lengthX;
    double lengthY;
    double height;
    glm::dvec3 z;
};

ConeAxes axesOf(const QuadricCone& cone) {
    std::array<glm::dvec3, 3> vectors = {cone.axisX, cone.axisY, cone.center};
    std::array<double, 3> lengths;
    for (int i = 0; i < 3; ++i) lengths[i] = glm::length(vectors[i]);
    // The shortest one may be rounding, and its direction noise: it follows from the other two.
    const int last =
        static_cast<int>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
    const int i = (last + 1) % 3;
    const int j = (last + 2) % 3;
    std::array<glm::dvec3, 3> e;
    e[i] = lengths[i] > 0.0 ? vectors[i] / lengths[i] : glm::dvec3(0.0);
    e[j] = lengths[j] > 0.0 ? vectors[j] / lengths[j] : glm::dvec3(0.0);
    e[last] = glm::cross(e[i], e[j]);
    lengths[last] = std::max(glm::dot(vectors[last], e[last]), 0.0);
    return {std::min(lengths[0], lengths[1]), lengths[1], lengths[2], {e[0].z, e[1].z, e[2].z}};
}

/// What an arc's integrals are made of.
struct ArcTerms {
    explicit ArcTerms(const ConeArc& arc)
        : cosine0(cosineOf(arc.first)),
          cosine1(cosineOf(arc.last)),
          sine0(2.0 * arc.first.cosine * arc.first.sine),
          sine1(2.0 * arc.last.cosine * arc.last.sine),
          sineHalf(cross(arc.first, arc.last)),
          cosineHalf(dot(arc.first, arc.last)),
          sineMean(arc.first.cosine * arc.last.sine + arc.first.sine * arc.last.cosine),
          sineRise(2.0 * sineHalf *
                   (arc.first.cosine * arc.last.cosine - arc.first.sine * arc.last.sine)),
          cosineRise(-2.0 * sineHalf * sineMean) {}

    static double cosineOf(const HalfAngle& half) {
        return (half.cosine - half.sine) * (half.cosine + half.sine);
    }

    double cosine0, cosine1, sine0, sine1;  ///< Of the two angles,
    double sineHalf, cosineHalf;            ///< of half their difference,
    double sineMean;                        ///< of their mean,
    double sineRise, cosineRise;            ///< and what they grow by.
};

/// The angle psi of arcIntegral() that an arc goes through, 0 to 2 pi.
double ownAngle(double p, double q, const ArcTerms& arc) {
    const double psi =
        std::atan2(2.0 * p * q * arc.sineHalf * arc.cosineHalf,
                   p * p * arc.cosine0 * arc.cosine1 + q * q * arc.sine0 * arc.sine1);
    // Half a turn may come as minus half a turn.
    return arc.cosineHalf < 0.0 ? psi + 2.0 * kPi : std::abs(psi);
}

/// The integral over one arc of a cone in its own axes. With A, B, C the lengths, P^2 = A^2 + C^2,
/// Q^2 = B^2 + C^2 and E^2 = B^2 - A^2 the three integrals are
///   -B C / (P E) [atan(E/P sin t)], A C / (Q E) [atanh(E/Q cos t)], A B / (P Q) [psi],
///   tan psi = Q/P tan t;
/// the differences are taken within the functions, by what differs.
double arcIntegral(const ConeAxes& axes, const ConeArc& arc) {
    const double a = axes.lengthX;
    const double b = axes.lengthY;
    const double c = axes.height;
    const double p2 = a * a + c * c;
    const double q2 = b * b + c * c;
    const double p = std::sqrt(p2);
    const double q = std::sqrt(q2);
    if (!(p > 0.0)) return 0.0;
    const double e2 = (b - a) * (b + a);
    const double e = std::sqrt(e2);

    const ArcTerms t(arc);
    const double y = e * p * t.sineRise;
    const double x = p2 + e2 * t.sine0 * t.sine1;
    const double sumX = -b * c * t.sineRise * (y != 0.0 ? std::atan2(y, x) / y : 1.0 / p2);
    // atanh x1 - atanh x0 = atanh u, u = (x1 - x0) / (1 - x0 x1); Q^2 (1 - x0 x1) without
    // cancellation.
    double sumY = 0.0;
    const double product = t.cosine0 * t.cosine1;
    const double bottom =
        product > 0.0 ? q2 * (t.sineHalf * t.sineHalf + t.sineMean * t.sineMean) + p2 * product
                      : q2 - e2 * product;
    if (bottom > 0.0) {
        const double u = std::abs(e * q * t.cosineRise / bottom);
        double ratio = 1.0;
        if (u > 0.5) {
            const double root = std::sqrt(p2 * t.cosine0 * t.cosine0 + q2 * t.sine0 * t.sine0) *
                                std::sqrt(p2 * t.cosine1 * t.cosine1 + q2 * t.sine1 * t.sine1);
            ratio = std::log((1.0 + u) * bottom / root) / u;
        } else if (u > 0.0) {
            ratio = std::atanh(u) / u;
        }
        sumY = a * c * t.cosineRise / bottom * ratio;
    }
    const double sumZ = a * b / (p * q) * ownAngle(p, q, t);
    return sumX * axes.z.x + sumY * axes.z.y + sumZ * axes.z.z;
}

/// The same less the integral over the chord, k (r0 x r1) with k = angle / (|r0| |r1| sin angle).
/// The arc's x and y components have factors that differ from k by the square of the cone's width;
/// all three are (1 + arcTangentTail(w)) / d.
double bulgeIntegral(const ConeAxes& axes, const ConeArc& arc) {
    const double a = axes.lengthX;
    const double b = axes.lengthY;
    const double c = axes.height;
    const double p = std::hypot(a, c);
    const double q = std::hypot(b, c);
    const double e = std::sqrt((b - a) * (b + a));
    const ArcTerms t(arc);
    // r0 x r1 and r0 . r1.
    const double x = -b * c * t.sineRise;
    const double y = a * c * t.cosineRise;
    const double z = 2.0 * a * b * t.sineHalf * t.cosineHalf;
    const double d = c * c + a * a * t.cosine0 * t.cosine1 + b * b * t.sine0 * t.sine1;
    const auto square = [](double value) { return value * value; };
    const double tail = arcTangentTail((x * x + y * y + z * z) / (d * d));
    // (1 + otherTail) / other - (1 + tail) / d for other = d + difference.
    const auto factorLess = [&](double difference, double rise, double sign) {
        const double other = d + difference;
        const double otherTail = arcTangentTail(sign * square(rise / other));
        return ((otherTail - tail) * d - (1.0 + tail) * difference) / (other * d);
    };
    const double lessX = factorLess(2.0 * square(a * t.sineHalf), e * p * t.sineRise, 1.0);
    const double lessY = factorLess(2.0 * square(b * t.sineHalf), e * q * t.cosineRise, -1.0);
    const double sumZ = a * b / (p * q) * ownAngle(p, q, t) - z * (1.0 + tail) / d;
    return x * lessX * axes.z.x + y * lessY * axes.z.y + sumZ * axes.z.z;
}

/// The sum over `arcs` of what `integral` makes of them.
template <typename Integral>
double sumOver(std::span<const ConeArc> arcs, const Reparametrization& map, const ConeAxes& axes,
               const Integral& integral) {
    double sum = 0.0;
    for (const ConeArc& arc : arcs) {
        sum += integral(axes, ConeArc{normalized(map(arc.first)), normalized(map(arc.last))});
    }
    return sum;
}

/// The cone in a size that squares well; none for one of no size.
std::optional<QuadricCone> scaled(const QuadricCone& cone) {
    const double scale =
        glm::length(cone.center) + glm::length(cone.axisX) + glm::length(cone.axisY);
    if (!(scale > 0.0)) return std::nullopt;
    return QuadricCone{cone.center / scale, cone.axisX / scale, cone.axisY / scale};
}

}  // namespace

HalfAngle normalized(const HalfAngle& angle) {
    const double length = std::hypot(angle.cosine, angle.sine);
    return {angle.cosine / length, angle.sine / length};
}

double dot(const HalfAngle& a, const HalfAngle& b) {
    return a.cosine * b.cosine + a.sine * b.sine;
}

double cross(const HalfAngle& a, const HalfAngle& b) {
    return a.cosine * b.sine - a.sine * b.cosine;
}

glm::dvec3 QuadricCone::offset(const HalfAngle& angle) const {
    return axisX * ((angle.cosine - angle.sine) * (angle.cosine + angle.sine)) +
           axisY * (2.0 * angle.cosine * angle.sine);
}

QuadricCone orthogonalized(QuadricCone cone) {
    orthogonalize(cone);
    return cone;
}

bool isInside(const ConeArc& arc, const HalfAngle& angle) {
    const HalfAngle x = cross(arc.first, angle) < 0.0 ? negated(angle) : angle;
    return cross(x, arc.last) >= 0.0;
}

std::optional<HorizonCrossings> crossings(const QuadricCone& cone, const glm::dvec3& normal) {
    // A quadratic form of the half angle: plus cos^2 + 2 mixed cos sin + minus sin^2.
    const double height = glm::dot(normal, cone.center);
    const double x = glm::dot(normal, cone.axisX);
    const double mixed = glm::dot(normal, cone.axisY);
    const double plus = height + x;
    const double minus = height - x;
    const double discriminant = mixed * mixed - plus * minus;
    if (!(discriminant > 0.0)) return std::nullopt;
    const double q = mixed + std::copysign(std::sqrt(discriminant), mixed);
    HorizonCrossings result;
    const bool isUp = !std::signbit(mixed);
    (isUp ? result.entering : result.leaving) = normalized({-q, plus});
    (isUp ? result.leaving : result.entering) = normalized({-minus, q});
    // Half the angle of (x, mixed).
    const double length = std::hypot(x, mixed);
    result.highest = x >= 0.0 ? normalized({length + x, mixed}) : normalized({mixed, length - x});
    result.lowest = {-result.highest.sine, result.highest.cosine};
    return result;
}

double arcIntegral(const QuadricCone& cone, std::span<const ConeArc> arcs) {
    if (arcs.empty()) return 0.0;
    std::optional<QuadricCone> own = scaled(cone);
    if (!own) return 0.0;
    const Reparametrization map = orthogonalize(*own);
    return sumOver(arcs, map, axesOf(*own),
                   [](const ConeAxes& axes, const ConeArc& arc) { return arcIntegral(axes, arc); });
}

std::optional<double> bulgeIntegral(const QuadricCone& cone, std::span<const ConeArc> arcs) {
    if (arcs.empty()) return 0.0;
    std::optional<QuadricCone> own = scaled(cone);
    if (!own) return std::nullopt;
    const Reparametrization map = orthogonalize(*own);
    const ConeAxes axes = axesOf(*own);
    if (!(axes.lengthY <= 0.1 * axes.height)) return std::nullopt;
    return sumOver(arcs, map, axes, [](const ConeAxes& ownAxes, const ConeArc& arc) {
        return bulgeIntegral(ownAxes, arc);
    });
}

double arcTangentTail(double w) {
    // 18 terms of at most a tenth of the one before.
    double sum = 0.0;
    for (int i = 18; i > 0; --i) sum = -w * (1.0 / (2 * i + 1) + sum);
    return sum;
}

}  // namespace polylume::ltc
