// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "figures/figure.hpp"
#include "figures/figure_folder.hpp"

namespace polylume::figures {

/// The Jacobian of the transform against finite differences, as a plot and a table. `quick`: over
/// fewer matrices.
Figure makeJacobianFigure(const FigureFolder& folder, bool quick);

}  // namespace polylume::figures
