// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "core/progress.hpp"
#include "figures/figure.hpp"
#include "figures/figure_folder.hpp"
#include "figures/picture_maker.hpp"

// The figures that set LTC pictures beside ray-traced ones. `quick`: of fewer cases.
namespace polylume::figures {

/// makeFloorScene() from smooth to rough, with the built-in table of one lobe.
Figure makeFloorFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                       Progress& progress);

/// failureCases().
Figure makeFailureFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                         Progress& progress);

/// makeFloorScene() with one lobe and with two.
Figure makeQualityFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                         Progress& progress);

/// shapeCases().
Figure makeShapeFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                       Progress& progress);

}  // namespace polylume::figures
