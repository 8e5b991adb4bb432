// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/canvas.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/log.hpp"
#include "image/image_io.hpp"

namespace polylume::figures {

Canvas::Canvas(int width, int height) {
    image_.width = width;
    image_.height = height;
    image_.channelCount = 3;
    image_.pixels.assign(static_cast<std::size_t>(width) * height * 3, 255);
}

void Canvas::set(int x, int y, const Color& color) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    const std::size_t offset = (static_cast<std::size_t>(y) * image_.width + x) * 3;
    std::copy(color.begin(), color.end(),
              image_.pixels.begin() + static_cast<std::ptrdiff_t>(offset));
}

void Canvas::blend(int x, int y, const Color& color, double share) {
    const std::size_t offset = (static_cast<std::size_t>(y) * image_.width + x) * 3;
    Color mixed{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double old = image_.pixels[offset + i];
        mixed[i] = static_cast<std::uint8_t>(std::lround(old + share * (color[i] - old)));
    }
    set(x, y, mixed);
}

void Canvas::fill(const Area& area, const Color& color) {
    for (int y = 0; y < area.height; ++y) {
        for (int x = 0; x < area.width; ++x) set(area.x + x, area.y + y, color);
    }
}

void Canvas::frame(const Area& area, const Color& color) {
    fill({area.x - 1, area.y - 1, area.width + 2, 1}, color);
    fill({area.x - 1, area.y + area.height, area.width + 2, 1}, color);
    fill({area.x - 1, area.y - 1, 1, area.height + 2}, color);
    fill({area.x + area.width, area.y - 1, 1, area.height + 2}, color);
}

void Canvas::paint(const Area& area, const std::function<Color(double, double)>& colorAt) {
    tbb::parallel_for(0, area.height, [&](int y) {
        for (int x = 0; x < area.width; ++x) {
            set(area.x + x, area.y + y, colorAt((x + 0.5) / area.width, (y + 0.5) / area.height));
        }
    });
}

void Canvas::drawLine(const glm::dvec2& from, const glm::dvec2& to, double width,
                      const Color& color) {
    const double reach = 0.5 * width + 1.0;
    const glm::dvec2 along = to - from;
    const double square = std::max(glm::dot(along, along), 1e-12);
    const glm::ivec2 first = glm::max(glm::ivec2(glm::min(from, to) - reach), glm::ivec2(0));
    const glm::ivec2 last = glm::min(glm::ivec2(glm::max(from, to) + reach),
                                     glm::ivec2(image_.width, image_.height) - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const glm::dvec2 middle(x + 0.5, y + 0.5);
            const double share = std::clamp(glm::dot(middle - from, along) / square, 0.0, 1.0);
            const double distance = glm::length(middle - from - share * along);
            blend(x, y, color, std::clamp(0.5 * width + 0.5 - distance, 0.0, 1.0));
        }
    }
}

void Canvas::addText(int x, int y, std::string text, TextAlign align, int size,
                     const Color& color) {
    labels_.push_back({std::move(text), x, y, size, align, color});
}

PixelImage Canvas::finish() {
    if (!drawText(image_, labels_)) {
        log(LogLevel::warning,
            "found no font: the picture comes without text (Debian: install fonts-dejavu-core)");
    }
    return std::move(image_);
}

void drawColorBar(Canvas& canvas, const Area& area, double most, const std::string& title) {
    constexpr int kTickCount = 5;
    canvas.paint(area, [](double, double y) { return heatColor(1.0 - y); });
    canvas.frame(area, kInk);
    for (int i = 0; i < kTickCount; ++i) {
        const double share = static_cast<double>(i) / (kTickCount - 1);
        const int y = area.y + area.height - 1 - static_cast<int>(share * (area.height - 1) + 0.5);
        canvas.fill({area.x + area.width + 1, y, 5, 1}, kInk);
        canvas.addText(area.x + area.width + 10, y, fmt::format("{:.3g}", share * most),
                       TextAlign::left);
    }
    canvas.addText(area.x, area.y - 22, title, TextAlign::left);
}

}  // namespace polylume::figures
