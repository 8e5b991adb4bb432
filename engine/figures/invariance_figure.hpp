// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "figures/figure.hpp"
#include "figures/figure_folder.hpp"

namespace polylume::figures {

/// A lobe of GGX, its linearly transformed cosine, the clamped cosine that it came from, a polygon
/// on each, and the integrals over them.
Figure makeInvarianceFigure(const FigureFolder& folder);

}  // namespace polylume::figures
