// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/sphere_form_factor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::tables {

double sphereFormFactor(double cosine, double sine) {
    constexpr double kPi = std::numbers::pi;
    const double square = sine * sine;
    const double cosHalf = std::sqrt(std::max(0.0, 1.0 - square));
    const double sineAngle = std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
    // Sines of the sphere's top and bottom above the horizon.
    if (cosine >= 0.0 && cosine >= sine) return cosine * square;
    if (cosine < 0.0 && -cosine >= sine) return 0.0;
    // The horizon cuts the sphere at the angle gamma: the parts G and H of Snyder 1996.
    const double gamma = std::asin(std::clamp(cosHalf / sineAngle, 0.0, 1.0));
    const double cosGamma = std::cos(gamma);
    const double sinGamma = std::sin(gamma);
    const double g =
        -2.0 * sineAngle * cosHalf * cosGamma + 0.5 * kPi - gamma + sinGamma * cosGamma;
    const double h = cosine * (cosGamma * std::sqrt(std::max(0.0, square - cosGamma * cosGamma)) +
                               square * std::asin(std::clamp(cosGamma / sine, 0.0, 1.0)));
    const double whole = cosine >= 0.0 ? cosine * square + (g - h) / kPi : (g + h) / kPi;
    return std::clamp(whole, 0.0, 1.0);
}

double sphereHorizonRatio(double cosine, double length) {
    // Below this the sphere is a point, above the horizon or below it.
    constexpr double kLeastLength = 1e-8;
    if (length < kLeastLength) return std::max(cosine, 0.0);
    return sphereFormFactor(cosine, std::sqrt(length)) / length;
}

}  // namespace polylume::tables
