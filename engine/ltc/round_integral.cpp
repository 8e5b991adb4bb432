// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/round_integral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "ltc/round_outline.hpp"

namespace polylume::ltc {
namespace {

/// What a point sees of a light.
struct Sight {
    double sign = 0.0;  ///< 1 of the emitting side, -1 of the back, 0 of neither.
    /// None: the light is all around.
    std::optional<RoundOutline> outline{};
};

Sight see(const EllipseShape& ellipse, const Lobe& /*lobe*/) {
    constexpr double kRelativeDistance = 1e-14;
    const double lengthX = glm::length(ellipse.halfAxisX);
    const double lengthY = glm::length(ellipse.halfAxisY);
    if (!(lengthX > 0.0) || !(lengthY > 0.0)) return {};
    const glm::dvec3 normal = glm::cross(ellipse.halfAxisX / lengthX, ellipse.halfAxisY / lengthY);
    const double sine = glm::length(normal);
    if (!(sine > 0.0)) return {};
    const double distance = glm::dot(normal / sine, ellipse.center);
    const double reach = glm::length(ellipse.center) + std::max(lengthX, lengthY);
    if (!(std::abs(distance) > kRelativeDistance * reach)) return {};
    // Outlines turn right-handed about what they hold, seen from the back as from the front.
    const double sign = distance < 0.0 ? 1.0 : -1.0;
    const QuadricCone cone{ellipse.center, ellipse.halfAxisX, -sign * ellipse.halfAxisY};
    return {sign, RoundOutline::ofCone(orthogonalized(cone))};
}

/// A unit vector at right angles to the unit vector `v`.
glm::dvec3 perpendicular(const glm::dvec3& v) {
    const glm::dvec3 other = std::abs(v.z) < 0.7 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    return glm::normalize(glm::cross(other, v));
}

struct Angle {
    double cosine;
    double sine;
};

/// Between a sphere's center and its rim, seen from a distance not below the radius.
Angle rimAngle(double distance, double radius) {
    return {std::sqrt((distance - radius) * (distance + radius)) / distance, radius / distance};
}

/// The rim of a sphere as it is seen from outside: a circle about center (1 - sin^2), of radius R
/// cos, where it is touched; here divided by the cosine, which the surface makes 0.
Sight see(const SphereShape& sphere, const Lobe& /*lobe*/) {
    const double distance = glm::length(sphere.center);
    if (!(sphere.radius > 0.0)) return {};
    if (distance < sphere.radius) return {-1.0};
    const glm::dvec3 axis = sphere.center / distance;
    const glm::dvec3 u = perpendicular(axis);
    const Angle rim = rimAngle(distance, sphere.radius);
    return {1.0, RoundOutline::ofCone({axis * (distance * rim.cosine), u * sphere.radius,
                                       glm::cross(axis, u) * sphere.radius})};
}

/// Half the angle of an angle from 0 to pi of cosine and sine in the ratio of these.
HalfAngle half(double cosine, double sine) {
    const double length = std::hypot(cosine, sine);
    return cosine >= 0.0 ? normalized({length + cosine, sine})
                         : normalized({sine, length - cosine});
}

/// A tube that is seen from the side: arcs of the ends' rims, and two straight edges along the
/// tube, each in a plane through the point that touches both ends. The axis passes the point at
/// `toAxis`, the ends are at `places` along it from there.
RoundOutline sideView(const TubeShape& tube, const glm::dvec3& axis,
                      const std::array<double, 2>& places, const glm::dvec3& toAxis,
                      const Lobe& lobe) {
    const double distance = glm::length(toAxis);
    const glm::dvec3 front = toAxis / distance;
    const glm::dvec3 side = glm::cross(front, axis);
    // On the surface itself a place that is next to it, so that directions stay what they are.
    Angle tangent = rimAngle(distance, tube.radius);
    tangent.cosine = std::max(tangent.cosine, 1e-16);
    const double length = glm::length(tube.end - tube.start);

    RoundOutline outline;
    std::array<ConeArc, 2> arcs;
    for (int i = 0; i < 2; ++i) {
        // The end, in the plane of the axis and the point.
        const double place = places[i];
        const double outward = i == 0 ? -1.0 : 1.0;
        const double centerDistance = std::hypot(distance, place);
        // Of the rim; the sum of squares keeps its digits near the surface.
        const double touchDistance = std::hypot(distance * tangent.cosine, place);
        const Angle rim{touchDistance / centerDistance, tube.radius / centerDistance};
        const glm::dvec3 center = front * distance + axis * place;
        const glm::dvec3 u = (axis * distance - front * place) * (outward / centerDistance);
        const double radius = tube.radius * rim.cosine;
        outline.cones[i] = {center * (rim.cosine * rim.cosine), u * radius,
                            side * (outward * radius)};
        outline.centerOffsets[i] = axis * (i * length) - center * (rim.sine * rim.sine);
        // The edges touch at +- this angle from the outermost point of the rim.
        const HalfAngle touch =
            half(outward * tangent.sine * place / centerDistance, tangent.cosine);
        arcs[i] = {{touch.cosine, -touch.sine}, touch};
    }
    const auto addEdge = [&](const OutlineCorner& from, const OutlineCorner& to, double turn) {
        const glm::dvec3 normal = front * tangent.sine + side * (turn * tangent.cosine);
        outline.addEdge(from, to, normal, transformedNormalZ(normal, lobe));
    };
    const OutlinePiece startArc = outline.arcPiece(0, arcs[0]);
    const OutlinePiece endArc = outline.arcPiece(1, arcs[1]);
    outline.pieces.push_back(endArc);
    addEdge(endArc.end, startArc.start, -1.0);
    outline.pieces.push_back(startArc);
    addEdge(startArc.end, endArc.start, 1.0);
    return outline;
}

Sight see(const TubeShape& tube, const Lobe& lobe) {
    if (!(tube.radius > 0.0)) return {};
    const bool startIsNearer = glm::length(tube.start) < glm::length(tube.end);
    const glm::dvec3& nearer = startIsNearer ? tube.start : tube.end;
    const SphereShape cap{nearer, tube.radius};
    const double length = glm::length(tube.end - tube.start);
    if (!(length > 0.0)) return see(cap, lobe);
    const glm::dvec3 axis = (tube.end - tube.start) / length;
    // From the nearer end, for views along the tube; twice, so that it is at right angles to the
    // axis however small it is.
    const double nearerPlace = glm::dot(nearer, axis);
    const glm::dvec3 rough = nearer - axis * nearerPlace;
    const glm::dvec3 toAxis = rough - axis * glm::dot(rough, axis);
    const double startPlace = startIsNearer ? nearerPlace : nearerPlace - length;
    const double endPlace = startIsNearer ? nearerPlace + length : nearerPlace;
    const bool isBeside = startPlace < 0.0 && endPlace > 0.0;
    const double distance = glm::length(toAxis);
    // A tube so thin that its axis goes through the point as exactly as numbers tell.
    if (isBeside && distance >= tube.radius &&
        distance <= 1e-15 * (glm::length(tube.start) + glm::length(tube.end))) {
        return {};
    }
    if (distance > tube.radius || (isBeside && distance == tube.radius)) {
        return {1.0, sideView(tube, axis, {startPlace, endPlace}, toAxis, lobe)};
    }
    return isBeside ? Sight{-1.0} : see(cap, lobe);
}

/// M^-1 of nothing but the shading frame itself: the cosine.
constexpr Lobe kCosine{};

template <typename Shape>
double cosineIntegral(const Shape& shape) {
    const Sight sight = see(shape, kCosine);
    if (sight.sign == 0.0 || !sight.outline) return sight.sign;
    return sight.sign * integrate(clipped(*sight.outline, {{0.0, 0.0, 1.0}, 1.0}), kCosine);
}

template <typename Shape>
double lobeIntegral(const Shape& shape, const Lobe& lobe) {
    const Sight sight = see(shape, lobe);
    if (sight.sign == 0.0 || !sight.outline) return sight.sign;
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const RoundOutline aboveSurface = clipped(*sight.outline, {up, transformedNormalZ(up, lobe)});
    const RoundOutline visible = clipped(aboveSurface, {{lobe.m31, 0.0, lobe.m33}, 1.0});
    return sight.sign * integrate(visible, lobe) / upperShare(lobe);
}

template <typename Shape>
double entryIntegral(const Shape& shape, const TableEntry& entry) {
    double sum = 0.0;
    for (int i = 0; i < entry.lobeCount; ++i) {
        sum += entry.shares[i] * lobeIntegral(shape, entry.lobes[i]);
    }
    return sum;
}

}  // namespace

double formFactor(const EllipseShape& ellipse) {
    return cosineIntegral(ellipse);
}
double formFactor(const SphereShape& sphere) {
    return cosineIntegral(sphere);
}
double formFactor(const TubeShape& tube) {
    return cosineIntegral(tube);
}

double lobeFormFactor(const EllipseShape& ellipse, const Lobe& lobe) {
    return lobeIntegral(ellipse, lobe);
}
double lobeFormFactor(const SphereShape& sphere, const Lobe& lobe) {
    return lobeIntegral(sphere, lobe);
}
double lobeFormFactor(const TubeShape& tube, const Lobe& lobe) {
    return lobeIntegral(tube, lobe);
}

double lobeFormFactor(const EllipseShape& ellipse, const TableEntry& entry) {
    return entryIntegral(ellipse, entry);
}
double lobeFormFactor(const SphereShape& sphere, const TableEntry& entry) {
    return entryIntegral(sphere, entry);
}
double lobeFormFactor(const TubeShape& tube, const TableEntry& entry) {
    return entryIntegral(tube, entry);
}

}  // namespace polylume::ltc
