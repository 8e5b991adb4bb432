// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/diverging_color.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "image/cie_lab.hpp"
#include "image/srgb.hpp"

namespace polylume::figures {

Color divergingColor(double value) {
    constexpr double kLightest = 96.0;
    constexpr double kDarkest = 36.0;
    constexpr double kMostChroma = 58.0;
    constexpr double kBlueHue = 288.0;  // Degrees.
    constexpr double kRedHue = 34.0;
    const double magnitude = std::min(std::abs(value), 1.0);
    const double hue = (value < 0.0 ? kBlueHue : kRedHue) * std::numbers::pi / 180.0;
    const double chroma = kMostChroma * magnitude;
    const double fy = (kLightest + (kDarkest - kLightest) * magnitude + 16.0) / 116.0;
    const glm::dvec3 xyz(labUnroot(fy + chroma * std::cos(hue) / 500.0), labUnroot(fy),
                         labUnroot(fy - chroma * std::sin(hue) / 200.0));
    // What sRGB can't show of the strongest colours is cut off.
    const glm::vec3 linear = glm::clamp(glm::inverse(kRelativeXyzFromLinear) * xyz, 0.0, 1.0);
    Color color{};
    for (int i = 0; i < 3; ++i) {
        color[static_cast<std::size_t>(i)] =
            static_cast<std::uint8_t>(std::lround(255.0f * srgbFromLinear(linear[i])));
    }
    return color;
}

void drawDivergingBar(Canvas& canvas, const Area& area, double most, const std::string& title) {
    canvas.paint(area, [](double x, double) { return divergingColor(2.0 * x - 1.0); });
    canvas.frame(area, kFaint);
    const int labelY = area.y + area.height + 12;
    const auto label = [&](double value) {
        return value == 0.0 ? std::string("0") : fmt::format("{:+.0f} %", 100.0 * value);
    };
    canvas.addText(area.x, labelY, label(-most), TextAlign::left, 14);
    canvas.addText(area.x + area.width / 2, labelY, label(0.0), TextAlign::middle, 14);
    canvas.addText(area.x + area.width, labelY, label(most), TextAlign::right, 14);
    canvas.addText(area.x - 8, area.y + area.height / 2, title, TextAlign::right, 14);
}

}  // namespace polylume::figures
