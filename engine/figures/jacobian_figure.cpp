// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/jacobian_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "figures/canvas.hpp"
#include "figures/jacobian_check.hpp"

namespace polylume::figures {
namespace {

constexpr Area kPlot = {90, 50, 620, 330};
constexpr int kLeastPower = -12;  // Of the deviation, at the plot's foot.
constexpr int kMostPower = 4;
constexpr int kLeastStepPower = -8;
constexpr int kMostStepPower = -1;
constexpr double kMeanWidth = 3.0;
constexpr double kLargestWidth = 1.2;

const std::array<Color, 3> kKindColors = {Color{30, 100, 200}, Color{20, 140, 90},
                                          Color{200, 70, 40}};

glm::dvec2 placeOf(double step, double deviation) {
    const double x = (std::log10(step) - kLeastStepPower) / (kMostStepPower - kLeastStepPower);
    const double power =
        std::clamp(std::log10(std::max(deviation, 1e-300)), kLeastPower + 0.0, kMostPower + 0.0);
    const double y = (power - kLeastPower) / (kMostPower - kLeastPower);
    return {kPlot.x + x * kPlot.width, kPlot.y + (1.0 - y) * kPlot.height};
}

void drawAxes(Canvas& canvas) {
    constexpr Color kGrid = {225, 225, 225};
    for (int power = kLeastPower; power <= kMostPower; power += 2) {
        const glm::dvec2 left = placeOf(std::pow(10.0, kLeastStepPower), std::pow(10.0, power));
        canvas.drawLine(left, left + glm::dvec2(kPlot.width, 0.0), 1.0, kGrid);
        canvas.addText(kPlot.x - 10, static_cast<int>(left.y), fmt::format("1e{}", power),
                       TextAlign::right, 15);
    }
    for (int power = kLeastStepPower; power <= kMostStepPower; ++power) {
        const glm::dvec2 foot = placeOf(std::pow(10.0, power), std::pow(10.0, kLeastPower));
        canvas.drawLine(foot, foot - glm::dvec2(0.0, kPlot.height), 1.0, kGrid);
        canvas.addText(static_cast<int>(foot.x), kPlot.y + kPlot.height + 18,
                       fmt::format("1e{}", power), TextAlign::middle, 15);
    }
    canvas.frame(kPlot, kInk);
    canvas.addText(kPlot.x + kPlot.width / 2, kPlot.y + kPlot.height + 42,
                   "size of the triangle [rad]", TextAlign::middle);
    canvas.addText(kPlot.x - 70, kPlot.y - 24, "relative deviation: mean (thick), largest (thin)",
                   TextAlign::left);
}

void drawCurve(Canvas& canvas, const JacobianRow& from, const JacobianRow& to) {
    const Color& color = kKindColors[static_cast<std::size_t>(from.kind)];
    canvas.drawLine(placeOf(from.step, from.mean), placeOf(to.step, to.mean), kMeanWidth, color);
    canvas.drawLine(placeOf(from.step, from.largest), placeOf(to.step, to.largest), kLargestWidth,
                    color);
}

PixelImage draw(const std::vector<JacobianRow>& rows) {
    Canvas canvas(kPlot.x + kPlot.width + 200, kPlot.y + kPlot.height + 70);
    drawAxes(canvas);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].kind == rows[i - 1].kind) drawCurve(canvas, rows[i - 1], rows[i]);
    }
    int y = kPlot.y + 30;
    for (const MatrixKind kind :
         {MatrixKind::table, MatrixKind::random, MatrixKind::nearSingular}) {
        const int x = kPlot.x + kPlot.width + 20;
        canvas.drawLine({x, y}, {x + 24, y}, kMeanWidth,
                        kKindColors[static_cast<std::size_t>(kind)]);
        canvas.addText(x + 32, y, nameOf(kind), TextAlign::left);
        y += 28;
    }
    return canvas.finish();
}

DataTable makeTable(const std::vector<JacobianRow>& rows) {
    DataTable table;
    table.title = "Relative deviation of the formula from finite differences";
    table.head = {"matrices", "triangle [rad]", "mean", "largest"};
    for (const JacobianRow& row : rows) {
        table.rows.push_back({nameOf(row.kind), fmt::format("{:.0e}", row.step),
                              fmt::format("{:.1e}", row.mean), fmt::format("{:.1e}", row.largest)});
    }
    return table;
}

}  // namespace

Figure makeJacobianFigure(const FigureFolder& folder, bool quick) {
    const int count = quick ? 1000 : 20000;
    const std::vector<JacobianRow> rows = checkJacobian(count);
    Figure figure;
    figure.name = "jacobian";
    figure.title = "Jacobian: ∂ω/∂ω₀ = |M| / ‖Mω₀‖³";
    figure.caption = {
        fmt::format(
            "How much larger a solid angle becomes under ω = Mω₀/‖Mω₀‖, by the formula (Heitz et "
            "al. 2016) and by finite differences: the solid angle of the image of a small "
            "spherical triangle over its own. {} seeded pairs of a matrix and a direction for "
            "each kind of matrix: M of the built-in GGX table's lobes, normally distributed "
            "numbers, and singular values down to a thousandth of the largest.",
            count),
        "The deviation falls with the square of the triangle's size, as it must when the formula "
        "is the limit, until the rounding of double precision, which grows as one over the size, "
        "takes over. The larger the ratio of M's singular values, the smaller the triangle has "
        "to be."};
    Panel panel;
    panel.pictures.emplace_back(
        "", folder.addPng("deviation", draw(rows),
                          "Deviation over the triangle's size: straight lines of slope 2 down to "
                          "rounding, then up again"));
    figure.panels.push_back(panel);
    figure.tables.push_back(makeTable(rows));
    return figure;
}

}  // namespace polylume::figures
