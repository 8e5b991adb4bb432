// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>

#include "compare/flip.hpp"

// Andersson et al. 2021.
namespace polylume::compare {
namespace {

/// (k0 x^2 + k1 x) / (k3 x^2 + k4 x + k5): the fit of the ACES reference rendering by Narkowicz
/// 2016, with the exposure of 0.6 that belongs to it taken in.
namespace aces {
constexpr double k0 = 0.6 * 0.6 * 2.51;
constexpr double k1 = 0.6 * 0.03;
constexpr double k3 = 0.6 * 0.6 * 2.43;
constexpr double k4 = 0.6 * 0.59;
constexpr double k5 = 0.14;

double toneMap(double x) {
    return std::min((k0 * x + k1) * x / ((k3 * x + k4) * x + k5), 1.0);
}

/// The x above 0 that is mapped to `t`, from above 0 to below 1.
double inverse(double t) {
    // x^2 + 2 p x + q = 0, q below 0.
    const double leading = k0 - k3 * t;
    const double p = 0.5 * (k1 - k4 * t) / leading;
    const double q = -k5 * t / leading;
    return -p + std::sqrt(p * p - q);
}
}  // namespace aces

/// The median of `values`, halfway between the middle two of an even count.
double medianOf(std::vector<double> values) {
    const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), upper, values.end());
    if (values.size() % 2 == 1) return *upper;
    return 0.5 * (*upper + *std::max_element(values.begin(), upper));
}

ColorImage exposed(const ColorImage& image, double exposure) {
    const double scale = std::exp2(exposure);
    ColorImage result;
    result.width = image.width;
    result.height = image.height;
    result.pixels.resize(image.pixels.size());
    forEachRow(image.height, [&](int y) {
        const std::size_t begin = static_cast<std::size_t>(y) * image.width;
        for (std::size_t i = begin; i < begin + image.width; ++i) {
            for (int channel = 0; channel < 3; ++channel) {
                const double radiance = std::max(image.pixels[i][channel], 0.0f);
                result.pixels[i][channel] = static_cast<float>(aces::toneMap(scale * radiance));
            }
        }
    });
    return result;
}

}  // namespace

ExposureRange exposuresOf(const ColorImage& reference) {
    std::vector<double> luminances;
    luminances.reserve(reference.pixels.size());
    for (const glm::vec3& pixel : reference.pixels) {
        const glm::dvec3 radiance = glm::max(glm::dvec3(pixel), 0.0);
        luminances.push_back(glm::dot(radiance, glm::dvec3(0.2126, 0.7152, 0.0722)));
    }
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    if (largest == 0.0) return {};
    double median = medianOf(luminances);
    if (median == 0.0) {
        std::erase(luminances, 0.0);
        median = medianOf(std::move(luminances));
    }
    constexpr double kToneMapped = 0.85;
    const double x = aces::inverse(kToneMapped);
    ExposureRange range;
    range.start = std::log2(x / largest);
    range.stop = std::log2(x / median);
    range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
    return range;
}

Plane hdrFlip(const ColorImage& test, const ColorImage& reference, const ExposureRange& exposures,
              double pixelsPerDegree, Progress& progress) {
    Plane largest(reference.width, reference.height);
    for (int i = 0; i < exposures.count; ++i) {
        const double step = exposures.count > 1 ? i / (exposures.count - 1.0) : 0.0;
        const double exposure = exposures.start + step * (exposures.stop - exposures.start);
        const Plane errors =
            displayFlip(exposed(test, exposure), exposed(reference, exposure), pixelsPerDegree);
        std::transform(errors.values.begin(), errors.values.end(), largest.values.begin(),
                       largest.values.begin(), [](float a, float b) { return std::max(a, b); });
        progress.update((i + 1.0) / exposures.count);
    }
    return largest;
}

}  // namespace polylume::compare
