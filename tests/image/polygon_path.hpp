// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "ltc/polygon_integral.hpp"
#include "ltc/table.hpp"
#include "polylume/light.hpp"

// What the polygon integral in double makes of every shape, once its outline is given as the shaded
// point sees it: the yardstick for the shapes' own methods.
namespace polylume::test {

/// A convex or triangulated part of the outline, relative to the point, in world axes; it turns
/// counter-clockwise as the point sees it.
using OutlinePart = ltc::Contour;

/// The outlines of all area lights at `point`: triangles of a polygonal light, `vertexCount`
/// vertices of another, of its own area where that can be said. Nothing of a light seen from
/// behind.
std::vector<OutlinePart> outlinesAt(const LightSet& lights, const glm::dvec3& point,
                                    int vertexCount);

/// A point and how it is looked at.
struct PathPoint {
    glm::dvec3 position, normal, view;  ///< Unit normal and view.
};

/// The form factors of `parts` for the cosine and, by `table`, for the specular reflection.
struct PathFactors {
    double cosine = 0.0;
    double specular = 0.0;
};
PathFactors polygonPath(const std::vector<OutlinePart>& parts, const PathPoint& point,
                        const ltc::TableEntry& entry);

}  // namespace polylume::test
