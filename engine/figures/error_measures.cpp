// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/error_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/flip.hpp"

namespace polylume::figures {
namespace {

double luminance(double red, double green, double blue) {
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue;  // Rec. 709.
}

double luminance(const float* color) {
    return luminance(color[0], color[1], color[2]);
}

/// The standard error of a pixel's luminance: exact where light and surfaces are grey, else the
/// most that it can be. Files hold the channels in another order than the ray tracer.
class StandardErrorReader {
  public:
    explicit StandardErrorReader(const FloatImage& image)
        : image_(image),
          red_(image.channelIndex("standardError.R")),
          green_(image.channelIndex("standardError.G")),
          blue_(image.channelIndex("standardError.B")) {}

    double at(int x, int y) const {
        if (!red_ || !green_ || !blue_) return 0.0;
        const float* pixel = image_.pixel(x, y);
        return luminance(pixel[*red_], pixel[*green_], pixel[*blue_]);
    }

  private:
    const FloatImage& image_;
    std::optional<std::size_t> red_;
    std::optional<std::size_t> green_;
    std::optional<std::size_t> blue_;
};

bool isCovered(const FloatImage& image, int x, int y) {
    constexpr float kWhole = 0.9999f;
    return image.pixel(x, y)[3] > kWhole;
}

compare::ColorImage colorsOf(const FloatImage& image) {
    compare::ColorImage colors{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float* pixel = image.pixel(x, y);
            colors.pixels.emplace_back(pixel[0], pixel[1], pixel[2]);
        }
    }
    return colors;
}

compare::Plane flipOf(const FloatImage& ltc, const FloatImage& truth) {
    const compare::ColorImage reference = colorsOf(truth);
    Progress unheard;
    return compare::hdrFlip(colorsOf(ltc), reference, compare::exposuresOf(reference),
                            compare::kDefaultPixelsPerDegree, unheard);
}

/// Sums over pixels.
struct Sums {
    double truth = 0.0;
    double difference = 0.0;
    double magnitude = 0.0;
    double square = 0.0;
    double flip = 0.0;
    double relative = 0.0;
    double noiseSquare = 0.0;
    int count = 0;
    int litCount = 0;
};

}  // namespace

ErrorMeasures measureErrors(const FloatImage& ltc, const FloatImage& truth) {
    const StandardErrorReader standardErrors(truth);
    const compare::Plane flip = flipOf(ltc, truth);
    Sums sums;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            if (!isCovered(ltc, x, y) || !isCovered(truth, x, y)) continue;
            const double wanted = luminance(truth.pixel(x, y));
            const double difference = luminance(ltc.pixel(x, y)) - wanted;
            ++sums.count;
            sums.truth += wanted;
            sums.difference += difference;
            sums.magnitude += std::abs(difference);
            sums.square += difference * difference;
            sums.flip += flip.row(y)[x];
            const double standardError = standardErrors.at(x, y);
            sums.noiseSquare += standardError * standardError;
            if (wanted <= 0.0) continue;
            sums.relative += std::abs(difference) / wanted;
            ++sums.litCount;
        }
    }
    ErrorMeasures measures;
    measures.pixelCount = sums.count;
    if (sums.litCount == 0) return measures;
    const double mean = sums.truth / sums.count;
    measures.meanRelative = sums.relative / sums.litCount;
    measures.noise = std::sqrt(sums.noiseSquare / sums.count) / mean;
    measures.meanAbsolute = sums.magnitude / sums.count / mean;
    measures.relativeRmse =
        std::sqrt(std::max(sums.square - sums.noiseSquare, 0.0) / sums.count) / mean;
    measures.bias = sums.difference / sums.count / mean;
    measures.flip = sums.flip / sums.count;
    return measures;
}

std::vector<float> relativeDifference(const FloatImage& ltc, const FloatImage& truth) {
    std::vector<float> values;
    for (int y = 0; y < truth.height; ++y) {
        for (int x = 0; x < truth.width; ++x) {
            if (!isCovered(ltc, x, y) || !isCovered(truth, x, y)) {
                values.push_back(std::numeric_limits<float>::quiet_NaN());
                continue;
            }
            const double wanted = luminance(truth.pixel(x, y));
            const double found = luminance(ltc.pixel(x, y));
            values.push_back(wanted > 0.0 ? static_cast<float>((found - wanted) / wanted) : 0.0f);
        }
    }
    return values;
}

}  // namespace polylume::figures
