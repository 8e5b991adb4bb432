// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "polylume/light.hpp"

// Where a flat light is and how large, from its vertices.
namespace polylume::scene {

/// A flat light in its frame.
struct FlatShape {
    glm::dvec3 center{0.0};  ///< Of its box along the axes.
    glm::dmat3 axes{1.0};    ///< Orthonormal, right-handed; it emits toward -Z.
    glm::dvec2 size{1.0};    ///< Full extents along X and Y; a tube's length is X.
};

/// A right-handed frame whose X is along `x` and whose Y is next to `y`; neither is zero.
glm::dmat3 rightFrame(const glm::dvec3& x, const glm::dvec3& y);

/// The rectangle whose corners these are, within the rounding of single precision, in the order of
/// makeRectangle(); none for another outline.
std::optional<FlatShape> rectangleOf(const PolygonLight& light);

/// The frame of a polygon light of any outline: Y along its first edge, as a rectangle has it.
FlatShape polygonFrame(const PolygonLight& light);

}  // namespace polylume::scene
