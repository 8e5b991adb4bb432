// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/error_figure.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "figures/canvas.hpp"
#include "fit/score_grid.hpp"
#include "fit/score_table.hpp"

namespace polylume::figures {
namespace {

constexpr double kMostDegrees = 89.5;
constexpr Area kMap = {90, 80, 640, 480};
constexpr int kCell = 4;  // Pixels along each side that one error stands for.

/// The errors of a grid, row by row from the normal view.
struct ErrorGrid {
    int columns = 0;
    int rows = 0;
    std::vector<double> errors;

    /// The largest at a roughness that scores count from on; beside that, what alpha's floor does
    /// within the first cell would set the scale.
    double most() const {
        double largest = 0.0;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double roughness = (static_cast<double>(i % columns) + 0.5) / columns;
            if (roughness >= fit::kLeastScoredRoughness) largest = std::max(largest, errors[i]);
        }
        return largest;
    }
};

ErrorGrid errorsOf(const brdf::Brdf& brdf, const ltc::Table& table, int columns, int rows) {
    ErrorGrid grid{columns, rows, std::vector<double>(static_cast<std::size_t>(columns) * rows)};
    const double single = fit::scoredRoughnesses(table, 2)[0];
    tbb::parallel_for(std::size_t{0}, grid.errors.size(), [&](std::size_t i) {
        const double u = (static_cast<double>(i % columns) + 0.5) / columns;
        const double v = (static_cast<double>(i / columns) + 0.5) / rows;
        const double roughness = table.size().columns == 1 ? single : u;
        const double cosine = fit::cosDegrees(kMostDegrees * v);
        grid.errors[i] = fit::scoreEntry(brdf, roughness, cosine, table.lookup(roughness, cosine));
    });
    return grid;
}

/// The next of 1, 1.5, 2, 3, 5, 7 times a power of ten.
double roundedUp(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-6))));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0}) {
        if (step * power >= value) return step * power;
    }
    return 10.0 * power;
}

void drawViewAxis(Canvas& canvas) {
    for (int degrees = 0; degrees <= 75; degrees += 15) {
        const int y = kMap.y + static_cast<int>(kMap.height * degrees / kMostDegrees);
        canvas.fill({kMap.x - 7, y, 6, 1}, kInk);
        canvas.addText(kMap.x - 12, y, fmt::format("{}", degrees), TextAlign::right);
    }
    canvas.addText(kMap.x - 40, kMap.y - 22, "view angle [degrees]", TextAlign::left);
}

void drawRoughnessAxis(Canvas& canvas) {
    for (int i = 0; i <= 5; ++i) {
        const int x = kMap.x + std::min(kMap.width * i / 5, kMap.width - 1);
        canvas.fill({x, kMap.y + kMap.height + 1, 1, 6}, kInk);
        canvas.addText(x, kMap.y + kMap.height + 18, fmt::format("{:.1f}", 0.2 * i),
                       TextAlign::middle);
    }
    canvas.addText(kMap.x + kMap.width / 2, kMap.y + kMap.height + 42, "perceptual roughness",
                   TextAlign::middle);
}

Canvas startFigure(const std::string& title) {
    Canvas canvas(kMap.x + kMap.width + 120, kMap.y + kMap.height + 70);
    canvas.addText(kMap.x, 24, title, TextAlign::left, 18);
    return canvas;
}

PixelImage drawMap(const ErrorGrid& grid, const std::string& title) {
    Canvas canvas = startFigure(title);
    const double most = roundedUp(grid.most());
    canvas.paint(kMap, [&](double u, double v) {
        const int column = static_cast<int>(u * grid.columns);
        const int row = static_cast<int>(v * grid.rows);
        return heatColor(grid.errors[static_cast<std::size_t>(row) * grid.columns + column] / most);
    });
    canvas.frame(kMap, kInk);
    drawViewAxis(canvas);
    drawRoughnessAxis(canvas);
    drawColorBar(canvas, {kMap.x + kMap.width + 30, kMap.y, 22, kMap.height}, most, "L1 error");
    return canvas.finish();
}

/// One column: the error as a curve over the view angle.
PixelImage drawCurve(const ErrorGrid& grid, const std::string& title) {
    Canvas canvas = startFigure(title);
    const double most = roundedUp(grid.most());
    canvas.paint(kMap, [&](double u, double v) {
        const int row = static_cast<int>(u * grid.rows);
        const double error = grid.errors[static_cast<std::size_t>(row)] / most;
        return 1.0 - v <= error ? heatColor(0.35) : kWhite;
    });
    canvas.frame(kMap, kInk);
    for (int degrees = 0; degrees <= 75; degrees += 15) {
        const int x = kMap.x + static_cast<int>(kMap.width * degrees / kMostDegrees);
        canvas.fill({x, kMap.y + kMap.height + 1, 1, 6}, kInk);
        canvas.addText(x, kMap.y + kMap.height + 18, fmt::format("{}", degrees), TextAlign::middle);
    }
    for (int i = 0; i <= 4; ++i) {
        const int y = kMap.y + kMap.height - 1 - (kMap.height - 1) * i / 4;
        canvas.fill({kMap.x - 7, y, 6, 1}, kInk);
        canvas.addText(kMap.x - 12, y, fmt::format("{:.3g}", most * i / 4), TextAlign::right);
    }
    canvas.addText(kMap.x + kMap.width / 2, kMap.y + kMap.height + 42, "view angle [degrees]",
                   TextAlign::middle);
    canvas.addText(kMap.x - 60, kMap.y - 22, "L1 error", TextAlign::left);
    return canvas.finish();
}

}  // namespace

PixelImage drawErrorFigure(const brdf::Brdf& brdf, const ltc::Table& table,
                           const std::string& title) {
    if (table.size().columns == 1) {
        return drawCurve(errorsOf(brdf, table, 1, kMap.width / kCell), title);
    }
    return drawMap(errorsOf(brdf, table, kMap.width / kCell, kMap.height / kCell), title);
}

}  // namespace polylume::figures
