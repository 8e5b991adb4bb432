// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "polylume/light.hpp"

namespace polylume {

/// Twice the area of a contour, along the normal of the side from which it turns counter-clockwise.
glm::dvec3 areaVector(const std::vector<glm::vec3>& contour);

/// A regular polygon of `sides` sides stretched to the ellipse, of the ellipse's area; it turns
/// counter-clockwise seen from the emitting side.
std::vector<glm::vec3> outline(const EllipseLight& light, int sides = 64);

}  // namespace polylume
