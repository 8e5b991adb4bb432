// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/comparison_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "figures/canvas.hpp"
#include "figures/diverging_color.hpp"
#include "image/display_transform.hpp"

namespace polylume::figures {
namespace {

/// The exposure that shows the luminance below which 99.5 % of the pixels lie at 0.95.
double exposureFor(const FloatImage& image) {
    constexpr double kShare = 0.995;
    constexpr double kShown = 0.95;
    std::vector<float> values;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) values.push_back(image.pixel(x, y)[1]);
    }
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(kShare * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    if (*place <= 0.0f) return 10.0;
    return -std::log2(kShown / (*place * exposureScale(0.0)));
}

PixelImage shown(const FloatImage& image, const FloatImage& truth) {
    return displayImage(image, exposureFor(truth), ToneMap::none, false);
}

/// The relative difference over a bar that tells its colours.
PixelImage differencePicture(const FloatImage& ltc, const FloatImage& truth) {
    constexpr int kFoot = 52;
    constexpr Color kBeside = {214, 214, 214};
    const std::vector<float> values = relativeDifference(ltc, truth);
    // Small pictures are drawn larger, so that the bar has room.
    constexpr int kLeastWidth = 480;
    const int scale = (kLeastWidth + truth.width - 1) / truth.width;
    const int width = scale * truth.width;
    const int height = scale * truth.height;
    Canvas canvas(width, height + kFoot);
    canvas.paint({0, 0, width, height}, [&](double x, double y) {
        const int column = static_cast<int>(x * truth.width);
        const int row = static_cast<int>(y * truth.height);
        const float value = values[static_cast<std::size_t>(row) * truth.width + column];
        return std::isnan(value) ? kBeside : divergingColor(value / kMostDifference);
    });
    drawDivergingBar(canvas, {width / 2 - 60, height + 12, width / 2 + 30, 12}, kMostDifference,
                     "(LTC - truth) / truth");
    return canvas.finish();
}

std::string percent(double value, int digits = 2) {
    return fmt::format("{:.{}f} %", 100.0 * value, digits);
}

}  // namespace

Picture writeTruth(const FigureFolder& folder, const Comparison& comparison) {
    const FloatImage& image = comparison.truth->image;
    folder.addExr(comparison.name + "_truth", image);
    return folder.addPng(comparison.name + "_truth", shown(image, image),
                         comparison.title + ", ray-traced");
}

Picture writeWithLight(const FigureFolder& folder, const Comparison& comparison,
                       const FloatImage& withLight) {
    return folder.addPng(comparison.name + "_light", shown(withLight, comparison.truth->image),
                         comparison.title + ", the floor and the light itself");
}

void addComparison(Panel& panel, const FigureFolder& folder, const Comparison& comparison,
                   const Picture& truth, const std::string& label) {
    const FloatImage& image = comparison.ltc.image;
    const FloatImage& wanted = comparison.truth->image;
    folder.addExr(comparison.name, image);
    PicturePair pair{
        label, "ray-traced",
        folder.addPng(comparison.name, shown(image, wanted), comparison.title + ", " + label),
        truth};
    panel.pairs.push_back(std::move(pair));
    panel.pictures.emplace_back(
        label + " minus ray-traced, relative",
        folder.addPng(comparison.name + "_difference", differencePicture(image, wanted),
                      fmt::format("{}: relative difference, {} on average", comparison.title,
                                  percent(comparison.errors.meanRelative))));
}

std::string describe(const ErrorMeasures& errors) {
    return fmt::format(
        "Mean relative error {}, mean |LTC − truth| {} of the mean, relative RMSE "
        "{}, bias {:+.2f} %, FLIP {:.4f}.",
        percent(errors.meanRelative), percent(errors.meanAbsolute), percent(errors.relativeRmse),
        100.0 * errors.bias, errors.flip);
}

std::vector<std::string> errorHead() {
    return {"mean relative error", "mean |LTC − truth| / mean truth", "relative RMSE", "bias",
            "FLIP"};
}

std::vector<std::string> errorCells(const ErrorMeasures& errors) {
    return {percent(errors.meanRelative), percent(errors.meanAbsolute),
            percent(errors.relativeRmse), fmt::format("{:+.2f} %", 100.0 * errors.bias),
            fmt::format("{:.4f}", errors.flip)};
}

std::vector<std::string> costHead() {
    return {"truth's standard error", "LTC [ms a frame]", "truth [s]", "truth [paths a pixel]"};
}

std::vector<std::string> costCells(const Comparison& comparison) {
    const TracedPicture& truth = *comparison.truth;
    return {percent(comparison.errors.noise),
            fmt::format("{:.1f}", 1000.0 * comparison.ltc.frameSeconds),
            fmt::format("{:.1f}", truth.seconds), fmt::format("{}", truth.pathCount)};
}

std::string explainComparisons(const PictureSettings& settings) {
    return fmt::format(
        "All compared pictures are of {}x{} pixels, sampled at {} position{} each, without "
        "shadows. Errors are of luminance over the pixels that the floor covers wholly. The mean "
        "relative error is the mean of |LTC − truth| / truth over lit pixels, dark ones included. "
        "The next three are the mean of |LTC − truth|, the root mean square and the mean of LTC − "
        "truth, each over the mean of the truth; what the truth's noise adds is taken out of the "
        "root mean square. FLIP is the mean of HDR-FLIP, from 0 for no visible difference to 1. "
        "The truth's standard error is its root mean square over the mean of the truth. An LTC "
        "frame is one position in each pixel, drawn in full.",
        settings.size.x, settings.size.y, settings.sampleCount,
        settings.sampleCount == 1 ? "" : "s");
}

}  // namespace polylume::figures
