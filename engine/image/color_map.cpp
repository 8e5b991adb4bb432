// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "image/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "image/cie_lab.hpp"

namespace polylume {
namespace {

/// Linear RGB of L*, chroma and hue of CIE 1976 L*a*b*.
glm::dvec3 linearOf(double light, double chroma, double hueDegrees) {
    const double hue = hueDegrees * std::numbers::pi / 180.0;
    const double fy = (light + 16.0) / 116.0;
    const double fx = fy + chroma * std::cos(hue) / 500.0;
    const double fz = fy - chroma * std::sin(hue) / 200.0;
    return glm::inverse(kRelativeXyzFromLinear) *
           glm::dvec3(labUnroot(fx), labUnroot(fy), labUnroot(fz));
}

bool isShown(const glm::dvec3& linear) {
    return std::min({linear.r, linear.g, linear.b}) >= 0.0 &&
           std::max({linear.r, linear.g, linear.b}) <= 1.0;
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double decoded(double value) {
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

Color heatColor(double value) {
    constexpr double kFirstLight = 8.0;
    constexpr double kLightRange = 87.0;
    constexpr double kFirstHue = 305.0;  // Violet; 90 more than a turn is yellow.
    constexpr double kHueRange = 150.0;
    const double t = std::clamp(value, 0.0, 1.0);
    // Rises and falls smoothly: along the gamut's own edge bands would show.
    const double wanted = 72.0 * std::sin(std::numbers::pi * (0.1 + 0.8 * t));
    const double light = kFirstLight + kLightRange * t;
    const double hue = kFirstHue + kHueRange * t;
    double low = 0.0;
    double high = wanted;
    if (isShown(linearOf(light, high, hue))) low = high;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (isShown(linearOf(light, middle, hue)) ? low : high) = middle;
    }
    const glm::dvec3 linear = glm::clamp(linearOf(light, low, hue), 0.0, 1.0);
    Color color{};
    for (int i = 0; i < 3; ++i) {
        color[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(std::lround(255.0 * encoded(linear[i])));
    }
    return color;
}

double lightness(const Color& color) {
    double luminance = 0.0;
    for (int i = 0; i < 3; ++i) {
        luminance +=
            kRelativeXyzFromLinear[i][1] * decoded(color[static_cast<std::size_t>(i)] / 255.0);
    }
    return 116.0 * labRoot(luminance) - 16.0;
}

}  // namespace polylume
