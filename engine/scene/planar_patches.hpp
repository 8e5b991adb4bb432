// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/welded_triangles.hpp"

namespace polylume::scene {

/// Neighbouring triangles in one plane, numbers into WeldedTriangles.
using Patch = std::vector<int>;

/// Splits triangles into connected patches that are planar: grown from the largest triangle that is
/// left over neighbours whose vertices are within 1e-4 of WeldedTriangles::extent of its plane, and
/// which face within half a degree the same way (triangles so low that rounding turns them need
/// only the first). With `texels`, the size of a texture, also the texture coordinates are affine
/// over each patch, within half a texel and a ten-thousandth of their distance.
std::vector<Patch> planarPatches(const WeldedTriangles& welded,
                                 const std::optional<glm::ivec2>& texels);

/// The unit normal of a patch, the mean by area.
glm::dvec3 patchNormal(const WeldedTriangles& welded, const Patch& patch);

/// The contours of a patch, projected into one plane that no triangle is in front of: first the
/// outline, counter-clockwise seen from the front, then the holes, clockwise. Vertices within
/// WeldedTriangles::weldDistance of the line between those that stay are left out. Empty where
/// rounding or overlaps leave no such contours.
std::vector<std::vector<glm::dvec3>> patchContours(const WeldedTriangles& welded,
                                                   const Patch& patch);

}  // namespace polylume::scene
