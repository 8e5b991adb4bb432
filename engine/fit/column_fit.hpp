// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "brdf/brdf.hpp"
#include "ltc/table.hpp"

namespace polylume::fit {

/// Fits one column of a table: `rowCount` entries for views from the normal (row 0) to the surface,
/// at one perceptual roughness, so that the entries and what lies between them on the straight line
/// from row to row are near the BRDF. `resolution` is that of Brdf::quadrature(). Depends on
/// nothing but its arguments.
std::vector<ltc::TableEntry> fitColumn(const brdf::Brdf& brdf, double roughness, int rowCount,
                                       int resolution);

}  // namespace polylume::fit
