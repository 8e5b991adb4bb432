// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image_compare.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/text.hpp"

namespace polylume::test {
namespace {

bool isFinite(const FloatImage& image) {
    return std::ranges::all_of(image.pixels, [](float value) { return std::isfinite(value); });
}

double meanMagnitude(const FloatImage& image) {
    double sum = 0.0;
    for (const float value : image.pixels) sum += std::abs(value);
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

std::string compareImages(const FloatImage& image, const FloatImage& reference,
                          const Tolerance& tolerance) {
    if (image.width != reference.width || image.height != reference.height) {
        return concat("expected ", reference.width, "x", reference.height, " pixels, found ",
                      image.width, "x", image.height);
    }
    if (image.channelNames != reference.channelNames) return "the channels have other names";
    if (!isFinite(image)) return "the image has a value that is not finite";
    if (!isFinite(reference)) return "the reference has a value that is not finite";

    const double floor = meanMagnitude(reference);
    std::size_t differing = 0;
    double worst = 0.0;
    std::string worstPixel;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            double excess = 0.0;
            for (std::size_t c = 0; c < image.channelCount(); ++c) {
                const double expected = reference.pixel(x, y)[c];
                const double error = std::abs(image.pixel(x, y)[c] - expected);
                excess = std::max(excess, error / std::max(std::abs(expected), floor));
            }
            if (excess > tolerance.relative) ++differing;
            if (excess > worst) {
                worst = excess;
                worstPixel = concat("(", x, ", ", y, "): ", image.pixel(x, y)[0], " in place of ",
                                    reference.pixel(x, y)[0]);
            }
        }
    }
    const double allowed = tolerance.outlierShare * image.width * image.height;
    if (static_cast<double>(differing) <= allowed) return "";
    return concat(differing, " of ", image.width * image.height, " pixels differ by more than ",
                  tolerance.relative, ", ", allowed, " may; the worst by ", worst, " at ",
                  worstPixel);
}

FloatImage differenceOf(const FloatImage& image, const FloatImage& reference) {
    FloatImage difference = reference;
    for (std::size_t i = 0; i < difference.pixels.size(); ++i) {
        difference.pixels[i] = std::abs(image.pixels[i] - reference.pixels[i]);
    }
    return difference;
}

}  // namespace polylume::test
