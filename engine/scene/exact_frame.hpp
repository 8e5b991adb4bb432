// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "polylume/light.hpp"
#include "scene/flat_frame.hpp"

// A light of the scene model is vertices or axes in single precision; a file says where its node
// stands and how large it is. Many such numbers lie within rounding of the light, and few of them
// are read back to it bit by bit. These functions look for one that is, so that a light which is
// written and read again gives the same picture to the last sample on its edge.
namespace polylume::scene {

/// Moves `shape` by rounding so that a "rect" of it is read as `corners`, four in the order of
/// makeRectangle(). False, and `shape` as it was, where no such was found.
bool findExactRectangle(const std::vector<glm::vec3>& corners, FlatShape& shape);

/// The same for an "ellipse".
bool findExactEllipse(const EllipseLight& light, FlatShape& shape);

/// The same for a "tube".
bool findExactTube(const TubeLight& light, FlatShape& shape);

/// The axes of a node, in double, that orthonormalFrame() reads as `frame`; the nearest where none
/// was found, as for a frame that is not the rounding of an orthonormal one.
glm::dmat3 findExactAxes(const glm::mat3& frame);

}  // namespace polylume::scene
