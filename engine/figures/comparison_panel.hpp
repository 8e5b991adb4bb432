// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "figures/error_measures.hpp"
#include "figures/figure.hpp"
#include "figures/figure_folder.hpp"
#include "figures/picture_maker.hpp"

namespace polylume::figures {

/// The relative difference that the strongest colours of a difference picture stand for.
inline constexpr double kMostDifference = 0.5;

/// Pictures of one scene and how far each is from the truth.
struct Comparison {
    std::string name;  ///< Of the files.
    std::string title;
    LtcPicture ltc;
    const TracedPicture* truth = nullptr;
    ErrorMeasures errors;
};

/// Writes the truth's files, NAME_truth.png and .exr. The PNG is linear in radiance up to the
/// brightest half percent of the pixels, then cut.
Picture writeTruth(const FigureFolder& folder, const Comparison& comparison);

/// Writes NAME_light.png, a picture of the scene with its light, as bright as the truth's.
Picture writeWithLight(const FigureFolder& folder, const Comparison& comparison,
                       const FloatImage& withLight);

/// Adds the pair LTC and truth and their difference to `panel` and writes their files: NAME.png and
/// .exr, NAME_difference.png. `label` says what the LTC picture is.
void addComparison(Panel& panel, const FigureFolder& folder, const Comparison& comparison,
                   const Picture& truth, const std::string& label);

/// The errors as one line.
std::string describe(const ErrorMeasures& errors);

/// The columns of errors that all comparisons share, and the cells of one.
std::vector<std::string> errorHead();
std::vector<std::string> errorCells(const ErrorMeasures& errors);

/// The columns of the truth's noise and of what both cost, and the cells.
std::vector<std::string> costHead();
std::vector<std::string> costCells(const Comparison& comparison);

/// What all comparisons have in common, and what their columns mean.
std::string explainComparisons(const PictureSettings& settings);

}  // namespace polylume::figures
