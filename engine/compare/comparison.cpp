// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "polylume/error.hpp"

namespace polylume::compare {
namespace {

/// part / whole, where nothing is nothing of anything.
double ratio(double part, double whole) {
    if (part == 0.0) return 0.0;
    return whole > 0.0 ? part / whole
                       : std::copysign(std::numeric_limits<double>::infinity(), part);
}

double psnrOf(double peak, double rmse) {
    if (rmse == 0.0) return std::numeric_limits<double>::infinity();
    return 20.0 * std::log10(peak / rmse);
}

Verdict judge(LimitKind kind, const std::string& layer, double limit, double found) {
    return {kind, layer, limit, found, found <= limit};
}

}  // namespace

LayerDifference differenceOf(const PicturePair& pair, const Layer& layer) {
    LayerDifference result;
    result.name = layer.name;
    result.channels = layer.channels;
    double sum = 0.0;
    double squareSum = 0.0;
    double absoluteSum = 0.0;
    double magnitudeSum = 0.0;
    double peak = 0.0;
    const int width = pair.reference().width;
    const int height = pair.reference().height;
    const std::size_t channelCount = layer.channels.size();
    result.maximumAt.channel = layer.channels.front();
    result.maximumAt.test = pair.test().pixel(0, 0)[layer.testIndices.front()];
    result.maximumAt.reference = pair.reference().pixel(0, 0)[layer.referenceIndices.front()];
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float* testPixel = pair.test().pixel(x, y);
            const float* referencePixel = pair.reference().pixel(x, y);
            for (std::size_t i = 0; i < channelCount; ++i) {
                const double test = testPixel[layer.testIndices[i]];
                const double reference = referencePixel[layer.referenceIndices[i]];
                const double difference = test - reference;
                sum += difference;
                squareSum += difference * difference;
                absoluteSum += std::abs(difference);
                magnitudeSum += std::abs(reference);
                peak = std::max(peak, std::abs(reference));
                if (std::abs(difference) > result.maximum) {
                    result.maximum = std::abs(difference);
                    result.maximumAt = {x, y, layer.channels[i], test, reference};
                }
            }
        }
    }
    const double count = static_cast<double>(width) * height * static_cast<double>(channelCount);
    result.rmse = std::sqrt(squareSum / count);
    result.bias = sum / count;
    result.meanAbsolute = absoluteSum / count;
    result.relativeRmse = ratio(result.rmse, magnitudeSum / count);
    result.relativeBias = ratio(result.bias, magnitudeSum / count);
    result.relativeMeanAbsolute = ratio(result.meanAbsolute, magnitudeSum / count);
    result.psnr = psnrOf(pair.reference().values == PixelValues::display ? 1.0 : peak, result.rmse);
    return result;
}

Comparison comparePictures(const PicturePair& pair, double pixelsPerDegree, Progress& progress) {
    Comparison comparison;
    comparison.width = pair.reference().width;
    comparison.height = pair.reference().height;
    comparison.values = pair.reference().values;
    comparison.hasColor = pair.hasColor();
    comparison.pixelsPerDegree = pixelsPerDegree;
    for (const Layer& layer : pair.layers()) {
        comparison.layers.push_back(differenceOf(pair, layer));
    }
    if (!pair.hasColor()) return comparison;

    const ColorImage test = pair.testColors();
    const ColorImage reference = pair.referenceColors();
    if (comparison.values == PixelValues::display) {
        comparison.flipMap = displayFlip(test, reference, pixelsPerDegree);
    } else {
        comparison.exposures = exposuresOf(reference);
        comparison.flipMap =
            hdrFlip(test, reference, *comparison.exposures, pixelsPerDegree, progress);
    }
    comparison.flip = summarize(comparison.flipMap);
    return comparison;
}

std::vector<Verdict> checkLimits(const Comparison& comparison, const Limits& limits) {
    std::vector<Verdict> verdicts;
    for (const LayerDifference& layer : comparison.layers) {
        if (limits.relativeRmse) {
            verdicts.push_back(judge(LimitKind::relativeRmse, layer.name, *limits.relativeRmse,
                                     layer.relativeRmse));
        }
        if (limits.maximum) {
            verdicts.push_back(
                judge(LimitKind::maximum, layer.name, *limits.maximum, layer.maximum));
        }
    }
    if (limits.meanFlip) {
        if (!comparison.flip) {
            throw Error(
                "expected colours to take FLIP of, R, G and B or a grey Y; found none in "
                "what is compared");
        }
        verdicts.push_back(judge(LimitKind::meanFlip, comparison.layers.front().name,
                                 *limits.meanFlip, comparison.flip->mean));
    }
    return verdicts;
}

}  // namespace polylume::compare
