// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <vector>

#include "polylume/light.hpp"

namespace polylume {

/// An edge of a polygon light in its plane.
struct PolygonEdge {
    glm::dvec2 from;
    glm::dvec2 to;
    std::size_t contour;
    std::size_t vertex;  ///< The one that it begins at.
};

/// What checkContours() works in; it keeps its memory from call to call.
struct PolygonCheckStorage {
    std::vector<PolygonEdge> edges;
    std::vector<const PolygonEdge*> sorted;
    std::vector<char> isInside;
};

/// Throws Error that names polygon light `index`, the contour and the vertex where the contours are
/// not as PolygonLight says. Finite contours of three vertices or more are taken for granted.
void checkContours(const PolygonLight& light, std::size_t index, PolygonCheckStorage& storage);

}  // namespace polylume
