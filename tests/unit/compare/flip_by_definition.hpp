// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "compare/flip.hpp"

namespace polylume::compare::test {

/// The colour error of two colours that fill their pictures, linear, from 0 to 1 (Andersson et al.
/// 2020, section 4.1): no filter changes them and there are no features.
double flipOfFlatColors(const glm::dvec3& a, const glm::dvec3& b);

/// FLIP of one pixel as the paper writes it down: full two-dimensional filters, YCxCz with its
/// scales and offsets, all in double precision.
double flipByDefinition(const ColorImage& test, const ColorImage& reference, int x, int y,
                        double pixelsPerDegree);

}  // namespace polylume::compare::test
