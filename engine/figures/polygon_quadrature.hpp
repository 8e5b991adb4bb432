// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <glm/glm.hpp>

#include "ltc/polygon_integral.hpp"

namespace polylume::figures {

/// The integral over the solid angle of a polygon of a function of the direction, by cubature
/// alone: nothing in it knows of cosines. `outline` is flat, simple, and seen from the origin,
/// either way round. Triangles are split until the rule changes by less than about 1e-11.
double integrateOverPolygon(const ltc::Contour& outline,
                            const std::function<double(const glm::dvec3&)>& function);

/// M^-1 of `lobe` on each vertex.
ltc::Contour transformed(const ltc::Contour& outline, const ltc::Lobe& lobe);

}  // namespace polylume::figures
