// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "compare/plane_filter.hpp"
#include "core/progress.hpp"
#include "image/image.hpp"

// FLIP says for each pixel how different two pictures look to someone who sees them in turns at one
// place of a screen: 0 is no difference, 1 the largest.
//     Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild 2020: FLIP: A Difference
//         Evaluator for Alternating Images (displayed pictures).
//     Andersson, Nilsson, Shirley, Akenine-Möller 2021: Visualizing Errors in Rendered High Dynamic
//         Range Images (HDR-FLIP).
namespace polylume::compare {

/// Linear Rec. 709 colours, row by row from the top.
struct ColorImage {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;  ///< width * height
};

/// The screen and the eye of the 2020 paper: 3840 pixels on 0.7 m, seen from 0.7 m.
inline constexpr double kDefaultPixelsPerDegree = 67.0;

/// FLIP of two pictures as a display shows them, of the same size, of values from 0 to 1 (beyond,
/// they are clamped). The same either way round. `pixelsPerDegree` is how many pixels fill a degree
/// of the observer's view, above 0.
Plane displayFlip(const ColorImage& test, const ColorImage& reference, double pixelsPerDegree);

/// The exposures that HDR-FLIP shows its pictures at: `count` of them, evenly from `start` to
/// `stop`, in stops: radiance is scaled by 2^exposure.
struct ExposureRange {
    double start = 0.0;
    double stop = 0.0;
    int count = 1;
};

/// The range of Andersson et al. 2021, section 4: from where the tone map takes the largest
/// luminance of `reference` to 0.85, to where it takes the median luminance there. Where the median
/// is 0, it is that of the pixels above 0; with none above 0 there is one exposure, 0.
ExposureRange exposuresOf(const ColorImage& reference);

/// HDR-FLIP of two pictures of radiance, of the same size: at each exposure both are tone-mapped
/// and displayFlip() taken; each pixel keeps its largest. Negative values count as 0.
Plane hdrFlip(const ColorImage& test, const ColorImage& reference, const ExposureRange& exposures,
              double pixelsPerDegree, Progress& progress);

/// What a map of FLIP comes to.
struct FlipSummary {
    double mean = 0.0;
    double weightedMedian = 0.0;  ///< Half of the sum of all errors lies in pixels up to this.
    double maximum = 0.0;
    int x = 0;  ///< Where the maximum is first, row by row.
    int y = 0;
};
FlipSummary summarize(const Plane& flip);

/// A picture of `flip` in the colours of heatColor().
PixelImage heatMap(const Plane& flip);

}  // namespace polylume::compare
