// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/sphere_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::figures {
namespace {

constexpr Color kOutline = {70, 220, 255};
constexpr Color kOutlineBehind = {60, 100, 120};
constexpr Color kHorizon = {170, 170, 170};
constexpr Color kHorizonBehind = {85, 85, 85};

Color mixed(const Color& a, const Color& b, double share) {
    Color result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = static_cast<std::uint8_t>(std::lround(a[i] + share * (b[i] - a[i])));
    }
    return result;
}

/// Part of the way along a great circle, in equal steps of the angle.
glm::dvec3 alongArc(const glm::dvec3& from, const glm::dvec3& to, double share) {
    const glm::dvec3 a = glm::normalize(from);
    const glm::dvec3 b = glm::normalize(to);
    const glm::dvec3 across = glm::normalize(b - glm::dot(a, b) * a);
    const double angle = share * std::atan2(glm::dot(b, across), glm::dot(a, b));
    return std::cos(angle) * a + std::sin(angle) * across;
}

}  // namespace

SphereView::SphereView(const Area& area, const glm::dvec3& toViewer)
    : area_(area),
      right_(glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), toViewer))),
      up_(glm::normalize(glm::cross(toViewer, right_))),
      toViewer_(glm::normalize(toViewer)) {}

std::optional<glm::dvec3> SphereView::directionAt(double x, double y) const {
    const double u = 2.0 * x - 1.0;
    const double v = 1.0 - 2.0 * y;
    const double square = u * u + v * v;
    if (square > 1.0) return std::nullopt;
    return u * right_ + v * up_ + std::sqrt(1.0 - square) * toViewer_;
}

glm::dvec2 SphereView::place(const glm::dvec3& point) const {
    const double radius = 0.5 * area_.width;
    return {area_.x + radius * (1.0 + glm::dot(point, right_)),
            area_.y + radius * (1.0 - glm::dot(point, up_))};
}

void SphereView::drawFunction(Canvas& canvas, const SphereFunction& function, double most) const {
    constexpr int kSamples = 3;  // Along each side of a pixel.
    constexpr double kPale = 0.45;
    canvas.paint(area_, [&](double x, double y) {
        double sum = 0.0;
        int insideCount = 0;
        int belowCount = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
            const double dx = ((i % kSamples + 0.5) / kSamples - 0.5) / area_.width;
            const double dy = ((i / kSamples + 0.5) / kSamples - 0.5) / area_.height;
            const auto direction = directionAt(x + dx, y + dy);
            if (!direction) continue;
            ++insideCount;
            if (direction->z < 0.0) ++belowCount;
            sum += function(*direction);
        }
        if (insideCount == 0) return kWhite;
        const Color color = mixed(heatColor(std::sqrt(sum / insideCount / most)), kWhite,
                                  kPale * belowCount / insideCount);
        return mixed(kWhite, color, static_cast<double>(insideCount) / (kSamples * kSamples));
    });
}

void SphereView::drawHorizon(Canvas& canvas) const {
    constexpr int kSteps = 180;
    for (int i = 0; i < kSteps; ++i) {
        const double from = 2.0 * std::numbers::pi * i / kSteps;
        const double to = 2.0 * std::numbers::pi * (i + 1) / kSteps;
        const glm::dvec3 a(std::cos(from), std::sin(from), 0.0);
        const glm::dvec3 b(std::cos(to), std::sin(to), 0.0);
        const bool front = glm::dot(a, toViewer_) > 0.0;
        if (!front && i % 4 > 1) continue;  // Dashed.
        canvas.drawLine(place(a), place(b), front ? 1.5 : 1.0, front ? kHorizon : kHorizonBehind);
    }
}

void SphereView::drawPolygon(Canvas& canvas, const ltc::Contour& outline) const {
    constexpr int kSteps = 60;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::dvec3& from = outline[i];
        const glm::dvec3& to = outline[(i + 1) % outline.size()];
        for (int j = 0; j < kSteps; ++j) {
            const glm::dvec3 a = alongArc(from, to, static_cast<double>(j) / kSteps);
            const glm::dvec3 b = alongArc(from, to, static_cast<double>(j + 1) / kSteps);
            const bool front = glm::dot(a, toViewer_) > 0.0;
            canvas.drawLine(place(a), place(b), front ? 2.5 : 1.0,
                            front ? kOutline : kOutlineBehind);
        }
    }
}

void SphereView::drawDirection(Canvas& canvas, const glm::dvec3& direction,
                               const std::string& name) const {
    constexpr double kEnd = 1.22;
    constexpr double kHead = 9.0;  // Pixels.
    // What lies behind the sphere is hidden up to its silhouette.
    const glm::dvec3 flat = direction - glm::dot(direction, toViewer_) * toViewer_;
    const bool behind = glm::dot(direction, toViewer_) < 0.0;
    const double start = behind ? 1.0 / std::max(glm::length(flat), 0.1) : 1.0;
    const glm::dvec2 tip = place(kEnd * direction);
    const glm::dvec2 foot = place(std::min(start, kEnd) * direction);
    const glm::dvec2 along = glm::normalize(tip - foot);
    const glm::dvec2 across(-along.y, along.x);
    canvas.drawLine(foot, tip, 2.0, kInk);
    canvas.drawLine(tip, tip - kHead * along + 0.5 * kHead * across, 2.0, kInk);
    canvas.drawLine(tip, tip - kHead * along - 0.5 * kHead * across, 2.0, kInk);
    const glm::dvec2 label = tip + 14.0 * along;
    canvas.addText(static_cast<int>(label.x), static_cast<int>(label.y), name, TextAlign::middle,
                   18);
}

}  // namespace polylume::figures
