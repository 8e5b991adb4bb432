// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/lobe_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/canvas.hpp"
#include "fit/lobe_model.hpp"
#include "fit/score_grid.hpp"
#include "fit/score_table.hpp"

namespace polylume::figures {
namespace {

constexpr int kDisk = 150;
constexpr int kGap = 10;
constexpr int kTop = 90;
constexpr int kRowHeight = kDisk + 44;
constexpr int kBlockWidth = 3 * kDisk + 2 * kGap;
constexpr int kBlockGap = 50;
constexpr int kMargin = 30;
constexpr int kSamples = 3;  // Along each side of a pixel.

/// The direction at a place of the disk, -1 to 1 to the right and up; false outside.
bool directionAt(double x, double y, glm::dvec3& direction) {
    const double square = x * x + y * y;
    if (square > 1.0) return false;
    // Lambert's projection of a hemisphere: 1 - z grows as the square of the radius.
    const double z = 1.0 - square;
    const double scale = square > 0.0 ? std::sqrt((1.0 - z * z) / square) : 0.0;
    direction = {x * scale, y * scale, z};
    return true;
}

/// What is drawn of a cell, per steradian.
class LobePair {
  public:
    LobePair(const brdf::Brdf& brdf, const ltc::Table& table, const LobeCell& cell)
        : brdf_(brdf),
          roughness_(cell.roughness),
          view_(brdf::viewDirection(fit::cosDegrees(cell.viewDegrees))),
          entry_(table.lookup(cell.roughness, fit::cosDegrees(cell.viewDegrees))),
          error_(fit::scoreEntry(brdf, cell.roughness, fit::cosDegrees(cell.viewDegrees), entry_)) {
    }

    double truth(const glm::dvec3& light) const { return brdf_.evaluate(view_, light, roughness_); }
    double model(const glm::dvec3& light) const {
        return entry_.albedo * fit::modelDensity(light, entry_);
    }
    double distance(const glm::dvec3& light) const { return std::abs(truth(light) - model(light)); }
    double error() const { return error_; }

    /// The largest value of the BRDF among the places of the disk's samples.
    double most() const {
        double largest = 1e-12;
        constexpr int kCount = kDisk * kSamples;
        for (int i = 0; i < kCount * kCount; ++i) {
            glm::dvec3 light;
            const double x = 2.0 * (i % kCount + 0.5) / kCount - 1.0;
            const double y = 2.0 * (i / kCount + 0.5) / kCount - 1.0;
            if (directionAt(x, y, light)) largest = std::max(largest, truth(light));
        }
        return largest;
    }

  private:
    const brdf::Brdf& brdf_;
    double roughness_;
    glm::dvec3 view_;
    ltc::TableEntry entry_;
    double error_;
};

/// Draws a function of the direction, by the square root of its share of `most`.
template <typename Function>
void drawDisk(Canvas& canvas, int left, int top, double most, Function function) {
    canvas.paint({left, top, kDisk, kDisk}, [&](double u, double v) {
        double sum = 0.0;
        int insideCount = 0;
        for (int i = 0; i < kSamples * kSamples; ++i) {
            const double du = ((i % kSamples + 0.5) / kSamples - 0.5) / kDisk;
            const double dv = ((i / kSamples + 0.5) / kSamples - 0.5) / kDisk;
            glm::dvec3 light;
            if (!directionAt(2.0 * (u + du) - 1.0, 1.0 - 2.0 * (v + dv), light)) continue;
            ++insideCount;
            sum += function(light);
        }
        if (insideCount == 0) return kWhite;
        const Color color = heatColor(std::sqrt(sum / insideCount / most));
        // The disk's edge, smooth.
        Color blended{};
        const int count = kSamples * kSamples;
        for (std::size_t i = 0; i < 3; ++i) {
            blended[i] = static_cast<std::uint8_t>(
                (color[i] * insideCount + 255 * (count - insideCount)) / count);
        }
        return blended;
    });
}

void drawCell(Canvas& canvas, int left, int top, const LobePair& pair, const LobeCell& cell) {
    const double most = pair.most();
    const auto column = [&](int index) { return left + index * (kDisk + kGap); };
    drawDisk(canvas, column(0), top, most, [&](const auto& light) { return pair.truth(light); });
    drawDisk(canvas, column(1), top, most, [&](const auto& light) { return pair.model(light); });
    drawDisk(canvas, column(2), top, most, [&](const auto& light) { return pair.distance(light); });
    canvas.addText(
        left, top + kDisk + 14,
        fmt::format("roughness {:.3g}, view {:.3g} degrees", cell.roughness, cell.viewDegrees),
        TextAlign::left, 15);
    canvas.addText(left + kBlockWidth, top + kDisk + 14, fmt::format("L1 {:.3f}", pair.error()),
                   TextAlign::right, 15);
}

}  // namespace

std::vector<LobeCell> defaultLobeCells() {
    return {{0.25, 30.0}, {0.25, 70.0}, {0.5, 45.0}, {0.5, 80.0}, {0.8, 60.0}, {1.0, 75.0}};
}

PixelImage drawLobeFigure(const brdf::Brdf& brdf, const ltc::Table& table,
                          const std::vector<LobeCell>& cells, const std::string& title) {
    const int blockCount = std::min<int>(2, static_cast<int>(cells.size()));
    const int rowCount = (static_cast<int>(cells.size()) + 1) / 2;
    constexpr int kBarSpace = 130;
    const int width =
        2 * kMargin + blockCount * kBlockWidth + (blockCount - 1) * kBlockGap + kBarSpace;
    Canvas canvas(width, kTop + rowCount * kRowHeight + 10);
    canvas.addText(kMargin, 24, title, TextAlign::left, 18);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        LobeCell cell = cells[i];
        if (table.size().columns == 1) cell.roughness = fit::scoredRoughnesses(table, 2)[0];
        const int left = kMargin + static_cast<int>(i % 2) * (kBlockWidth + kBlockGap);
        const int top = kTop + static_cast<int>(i / 2) * kRowHeight;
        drawCell(canvas, left, top, LobePair(brdf, table, cell), cell);
        if (i >= 2) continue;
        int x = left + kDisk / 2;
        for (const char* heading : {"BRDF x cos", "fit", "|difference|"}) {
            canvas.addText(x, kTop - 20, heading, TextAlign::middle);
            x += kDisk + kGap;
        }
    }
    drawColorBar(canvas, {width - 100, kTop, 22, rowCount * kRowHeight - 44}, 1.0, "sqrt(f / max)");
    return canvas.finish();
}

}  // namespace polylume::figures
