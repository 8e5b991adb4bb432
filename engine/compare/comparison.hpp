// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/flip.hpp"
#include "compare/picture_pair.hpp"
#include "core/progress.hpp"

namespace polylume::compare {

/// A pixel's value in one channel of both pictures.
struct ValueAt {
    int x = 0;  ///< From the left, from 0.
    int y = 0;  ///< From the top, from 0.
    std::string channel;
    double test = 0.0;
    double reference = 0.0;
};

/// How far the test picture's channels of one layer are from the reference's, over all their
/// values, in double precision.
struct LayerDifference {
    std::string name;
    std::vector<std::string> channels;
    double rmse = 0.0;          ///< Root of the mean square of test - reference.
    double bias = 0.0;          ///< Mean of test - reference.
    double meanAbsolute = 0.0;  ///< Mean of |test - reference|.
    /// All three divided by the reference's mean magnitude, which is its mean where nothing is
    /// negative. 0 where the difference is 0, infinite where the reference alone is 0 all over.
    double relativeRmse = 0.0;
    double relativeBias = 0.0;
    double relativeMeanAbsolute = 0.0;
    double maximum = 0.0;  ///< The largest |test - reference|.
    ValueAt maximumAt;     ///< Its first place, row by row.
    /// 20 log10(peak / rmse) in dB, the peak being 1 for display values and the reference's largest
    /// magnitude for linear ones. Infinite where the rmse is 0; -infinite where the peak alone is.
    double psnr = 0.0;
};
LayerDifference differenceOf(const PicturePair& pair, const Layer& layer);

struct Comparison {
    int width = 0;
    int height = 0;
    PixelValues values = PixelValues::linear;
    bool hasColor = false;                ///< The first layer holds the picture's colours.
    std::vector<LayerDifference> layers;  ///< As PicturePair::layers() has them; at least one.
    double pixelsPerDegree = 0.0;
    std::optional<FlipSummary> flip;         ///< None without colours.
    std::optional<ExposureRange> exposures;  ///< Of HDR-FLIP, for linear values alone.
    Plane flipMap;                           ///< Empty without colours.
};

/// Measures all layers and takes FLIP of the colours: of 2020 for display values, HDR-FLIP for
/// linear ones.
Comparison comparePictures(const PicturePair& pair, double pixelsPerDegree, Progress& progress);

/// The largest differences that are allowed, each from 0; none: any.
struct Limits {
    std::optional<double> relativeRmse;  ///< Of each layer.
    std::optional<double> maximum;       ///< Of each layer.
    std::optional<double> meanFlip;      ///< Of the colours.
};

enum class LimitKind { relativeRmse, maximum, meanFlip };

/// One limit and what was found there.
struct Verdict {
    LimitKind kind{};
    std::string layer;
    double limit = 0.0;
    double found = 0.0;
    bool passed = false;  ///< The limit itself passes.
};

/// One verdict for each limit and layer that it holds for. Throws Error where FLIP is limited and
/// the pictures have no colours.
std::vector<Verdict> checkLimits(const Comparison& comparison, const Limits& limits);

}  // namespace polylume::compare
