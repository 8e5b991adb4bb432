// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>

#include "polylume/light.hpp"

namespace polylume {

/// Throws Error that names polygon light `index`, the contour and the vertex where the contours are
/// not as PolygonLight says. Finite contours of three vertices or more are taken for granted.
void checkContours(const PolygonLight& light, std::size_t index);

}  // namespace polylume
