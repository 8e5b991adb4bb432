// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ltc/table_layout.hpp"

// The integrals that the shaders compute, in double, for tests and for the reference. The shading
// frame has z along the normal. Outlines turn counter-clockwise seen from the light's emitting
// side, so a point in front of the light sees them counter-clockwise and gets a positive value;
// holes turn the other way. The contours of one polygon lie in one plane, in any number, of any
// number of vertices.
namespace polylume::ltc {

using Contour = std::vector<glm::dvec3>;

/// Form factor E of a polygon for a clamped cosine along z: integral of cos/pi over the part of it
/// above z = 0, -1 to 1. Positive where the point sees the emitting side, negative where it sees
/// the back; the absolute value is what a two-sided light gives. Vertices are relative to the
/// shaded point, in any unit. 0 where the point lies in the polygon's plane (within 1e-14 of the
/// largest distance to a vertex) or the polygon has no area (Lambert 1760; Baum et al. 1989).
double formFactor(std::span<const Contour> contours);

/// The same after M^-1 of `lobe`, divided by the share H of the lobe above the surface: the
/// specular integral over the polygon as a fraction of the lobe, -1 to 1 (design: surface clip,
/// M^-1, second clip, sum, E/H).
double lobeFormFactor(std::span<const Contour> contours, const Lobe& lobe);

/// The same for all lobes of `entry`, each by its share.
double lobeFormFactor(std::span<const Contour> contours, const TableEntry& entry);

}  // namespace polylume::ltc
