// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "brdf/brdf.hpp"
#include "image/image.hpp"
#include "ltc/table.hpp"

namespace polylume::figures {

/// A place in a table to draw the lobes of.
struct LobeCell {
    double roughness = 0.5;
    double viewDegrees = 60.0;  ///< From the normal, below 90.
};

/// Six cells from smooth to rough and from steep to grazing.
std::vector<LobeCell> defaultLobeCells();

/// For each cell, side by side, the BRDF times cosine, the table's fit of it as looked up, and how
/// far they are apart, each over the hemisphere seen from above (Lambert's equal-area azimuthal
/// projection): the viewer on the right, a mirror reflecting to the left. Colours are by the square
/// root, so that tails show, on one scale for each cell. A table of one column is drawn at its own
/// roughness.
PixelImage drawLobeFigure(const brdf::Brdf& brdf, const ltc::Table& table,
                          const std::vector<LobeCell>& cells, const std::string& title);

}  // namespace polylume::figures
