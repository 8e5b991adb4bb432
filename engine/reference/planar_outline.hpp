// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace polylume::reference {

using PlanarContour = std::vector<glm::dvec2>;

/// Whether `point` lies within the contours by the even-odd rule.
bool isInside(const std::vector<PlanarContour>& contours, const glm::dvec2& point);

/// Convex parts without overlap, turning counter-clockwise, that cover what the even-odd rule says
/// is within: a convex contour itself; else trapezoids between neighbouring heights of vertices (as
/// Seidel 1991 has them, found by looking at all edges), for contours that do not cross.
std::vector<PlanarContour> convexParts(const std::vector<PlanarContour>& contours);

/// The convex hull of a contour, counter-clockwise (Andrew 1979).
PlanarContour convexHull(PlanarContour contour);

/// Of a contour that turns counter-clockwise.
double area(const PlanarContour& contour);

}  // namespace polylume::reference
