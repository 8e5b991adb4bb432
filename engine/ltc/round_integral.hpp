// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "ltc/table_layout.hpp"

// The integrals of polygon_integral.hpp over round lights, in double and in closed form. Places are
// relative to the shaded point, in the shading frame (z along the normal), in any unit.
//
// Values are shares from -1 to 1, but for rounding, which nothing hides: positive where the point
// sees the emitting side, negative where it sees the back; the absolute value is what a two-sided
// light gives. Both horizons, the surface's and the lobe's, count as exactly as the outline does.
namespace polylume::ltc {

/// Emits toward cross(halfAxisX, halfAxisY), which should be at right angles (conjugate half axes
/// do as well). A point in its plane (within 1e-14 of its size and distance) gets 0.
struct EllipseShape {
    glm::dvec3 center;
    glm::dvec3 halfAxisX;
    glm::dvec3 halfAxisY;
};

/// A point inside sees the back all around: -1. One on the surface gets the value from outside.
struct SphereShape {
    glm::dvec3 center;
    double radius;
};

/// A capsule: all within `radius` of the line from `start` to `end`. Inside as SphereShape; 0 for
/// no radius, or for one so small that the axis passes through the point within rounding.
struct TubeShape {
    glm::dvec3 start;
    glm::dvec3 end;
    double radius;
};

/// Form factor for a clamped cosine along z: integral of cos/pi over the part of the light above z
/// = 0.
double formFactor(const EllipseShape& ellipse);
double formFactor(const SphereShape& sphere);
double formFactor(const TubeShape& tube);

/// The same after M^-1 of `lobe`, divided by the share H of the lobe above the surface.
double lobeFormFactor(const EllipseShape& ellipse, const Lobe& lobe);
double lobeFormFactor(const SphereShape& sphere, const Lobe& lobe);
double lobeFormFactor(const TubeShape& tube, const Lobe& lobe);

/// The same for all lobes of `entry`, each by its share.
double lobeFormFactor(const EllipseShape& ellipse, const TableEntry& entry);
double lobeFormFactor(const SphereShape& sphere, const TableEntry& entry);
double lobeFormFactor(const TubeShape& tube, const TableEntry& entry);

}  // namespace polylume::ltc
