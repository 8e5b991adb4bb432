// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace polylume::scene {

/// A triangle of a surface in the world, counter-clockwise seen from its front.
struct SurfaceTriangle {
    std::array<glm::dvec3, 3> positions;
    std::array<glm::dvec2, 3> texCoords{};
};

/// Triangles of which equal corners are one vertex, and which know their neighbours. What is
/// degenerate or there twice is left out.
struct WeldedTriangles {
    static constexpr int kNone = -1;

    std::vector<SurfaceTriangle> triangles;
    std::vector<glm::dvec3> positions;                  ///< Of the vertices.
    std::vector<std::array<std::uint32_t, 3>> corners;  ///< Of each triangle, into positions.
    std::vector<glm::dvec3> areaVectors;  ///< Of each triangle: its area along its normal.
    /// Across the edge from corner k to the next: the triangle there that faces much the same way,
    /// or kNone. Mutual, and none where several would do.
    std::vector<std::array<int, 3>> neighbours;
    double extent = 0.0;        ///< The diagonal of the box around all.
    double weldDistance = 0.0;  ///< Vertices nearer than this are one.
    int surfaceCount = 0;       ///< Of triangles joined by edges, whichever way they face.
};

/// Vertices weld at a millionth of the extent, or where single precision holds less at their
/// distance from the origin, at what it holds. A triangle lower than that is degenerate.
WeldedTriangles weld(const std::vector<SurfaceTriangle>& triangles);

}  // namespace polylume::scene
