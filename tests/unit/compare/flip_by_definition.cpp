// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "flip_by_definition.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace polylume::compare::test {
namespace {

constexpr double kPi = std::numbers::pi;

// IEC 61966-2-1 with its own white.
const glm::dmat3 kXyzFromRgb = glm::transpose(
    glm::dmat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505));
const glm::dvec3 kWhite(0.9505, 1.0, 1.0890);

glm::dvec3 ycxczOf(const glm::dvec3& rgb) {
    const glm::dvec3 v = kXyzFromRgb * rgb / kWhite;
    return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
}

glm::dvec3 rgbOf(const glm::dvec3& ycxcz) {
    const double y = (ycxcz.x + 16.0) / 116.0;
    const glm::dvec3 v(y + ycxcz.y / 500.0, y, y - ycxcz.z / 200.0);
    return glm::inverse(kXyzFromRgb) * (v * kWhite);
}

double labFunction(double t) {
    const double knee = std::pow(6.0 / 29.0, 3.0);
    return t > knee ? std::cbrt(t) : 841.0 / 108.0 * t + 4.0 / 29.0;
}

glm::dvec3 huntLabOf(const glm::dvec3& rgb) {
    const glm::dvec3 v = kXyzFromRgb * rgb / kWhite;
    const double light = 116.0 * labFunction(v.y) - 16.0;
    const double a = 500.0 * (labFunction(v.x) - labFunction(v.y));
    const double b = 200.0 * (labFunction(v.y) - labFunction(v.z));
    return {light, 0.01 * light * a, 0.01 * light * b};
}

double distance(const glm::dvec3& a, const glm::dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

using Weights = std::function<double(int, int)>;

/// The sum of `value` over a square, weighted; beyond the border the nearest pixel counts.
template <typename Value>
auto gather(const ColorImage& image, int x, int y, int radius, const Weights& weight,
            const Value& value) {
    auto sum = 0.0 * value(glm::dvec3(0.0));
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
            const int column = std::clamp(x + i, 0, image.width - 1);
            const int row = std::clamp(y + j, 0, image.height - 1);
            const auto index = static_cast<std::size_t>(row * image.width + column);
            sum += weight(i, j) * value(glm::dvec3(image.pixels[index]));
        }
    }
    return sum;
}

double sumOf(int radius, const Weights& weight) {
    double sum = 0.0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) sum += weight(i, j);
    }
    return sum;
}

glm::dvec3 seenColor(const ColorImage& image, int x, int y, double pixelsPerDegree) {
    const auto sensitivity = [&](double a, double b, int i, int j) {
        const double squared = (i * i + j * j) / (pixelsPerDegree * pixelsPerDegree);
        return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi / b * squared);
    };
    const Weights weights[3] = {[&](int i, int j) { return sensitivity(1.0, 0.0047, i, j); },
                                [&](int i, int j) { return sensitivity(1.0, 0.0053, i, j); },
                                [&](int i, int j) {
                                    return sensitivity(34.1, 0.04, i, j) +
                                           sensitivity(13.5, 0.025, i, j);
                                }};
    const int radius =
        static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * pixelsPerDegree));
    glm::dvec3 filtered;
    for (int channel = 0; channel < 3; ++channel) {
        filtered[channel] = gather(image, x, y, radius, weights[channel],
                                   [&](const glm::dvec3& rgb) { return ycxczOf(rgb)[channel]; }) /
                            sumOf(radius, weights[channel]);
    }
    return huntLabOf(glm::clamp(rgbOf(filtered), 0.0, 1.0));
}

/// The magnitude of the response to edges, or to points, in both directions.
double featureAt(const ColorImage& image, int x, int y, double pixelsPerDegree, bool isPoint) {
    const double sigma = 0.5 * 0.082 * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const Weights raw = [&](int i, int j) {
        const double gaussian = std::exp(-(i * i + j * j) / (2.0 * sigma * sigma));
        return isPoint ? (i * i / (sigma * sigma) - 1.0) * gaussian : -i * gaussian;
    };
    const double positive = sumOf(radius, [&](int i, int j) { return std::max(raw(i, j), 0.0); });
    const double negative = sumOf(radius, [&](int i, int j) { return std::max(-raw(i, j), 0.0); });
    const auto alongX = [&](int i, int j) {
        return raw(i, j) / (raw(i, j) > 0.0 ? positive : negative);
    };
    const auto light = [](const glm::dvec3& rgb) { return (ycxczOf(rgb).x + 16.0) / 116.0; };
    return std::hypot(gather(image, x, y, radius, alongX, light),
                      gather(
                          image, x, y, radius, [&](int i, int j) { return alongX(j, i); }, light));
}

double errorOf(double hybridDistance) {
    const double largest =
        std::pow(distance(huntLabOf({0.0, 1.0, 0.0}), huntLabOf({0.0, 0.0, 1.0})), 0.7);
    const double powered = std::pow(hybridDistance, 0.7);
    const double knee = 0.4 * largest;
    if (powered < knee) return 0.95 / knee * powered;
    return 0.95 + (powered - knee) / (largest - knee) * 0.05;
}

}  // namespace

double flipOfFlatColors(const glm::dvec3& a, const glm::dvec3& b) {
    return errorOf(distance(huntLabOf(a), huntLabOf(b)));
}

double flipByDefinition(const ColorImage& test, const ColorImage& reference, int x, int y,
                        double pixelsPerDegree) {
    const double color = errorOf(distance(seenColor(test, x, y, pixelsPerDegree),
                                          seenColor(reference, x, y, pixelsPerDegree)));
    const auto difference = [&](bool isPoint) {
        return std::abs(featureAt(test, x, y, pixelsPerDegree, isPoint) -
                        featureAt(reference, x, y, pixelsPerDegree, isPoint));
    };
    const double feature =
        std::sqrt(std::max(difference(false), difference(true)) / std::numbers::sqrt2);
    return std::pow(color, 1.0 - feature);
}

}  // namespace polylume::compare::test
