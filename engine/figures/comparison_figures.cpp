// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/comparison_figures.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "figures/comparison_panel.hpp"
#include "figures/comparison_scenes.hpp"
#include "figures/partial_progress.hpp"
#include "figures/shape_scenes.hpp"

namespace polylume::figures {
namespace {

std::vector<double> roughnesses(bool quick) {
    if (quick) return {0.2, 0.5};
    return {0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0};
}

std::string nameOf(double roughness) {
    return fmt::format("r{:.2f}", roughness);
}

/// `scene` as LTC draw it, beside `truth`, to which a reference is kept.
Comparison compareScene(PictureMaker& maker, const std::string& name, const std::string& title,
                        const scene::Scene& scene, Quality quality, const TracedPicture& truth) {
    Comparison comparison;
    comparison.name = name;
    comparison.title = title;
    comparison.ltc = maker.drawLtc(scene, quality, true);
    comparison.truth = &truth;
    comparison.errors = measureErrors(comparison.ltc.image, truth.image);
    return comparison;
}

Comparison compareFloor(PictureMaker& maker, double roughness, Quality quality,
                        Progress& progress) {
    return compareScene(maker, nameOf(roughness), fmt::format("Roughness {:.2f}", roughness),
                        makeFloorScene(roughness), quality, maker.tracedFloor(roughness, progress));
}

/// Those that are made, of all.
template <typename Case>
std::vector<Case> shownCases(std::vector<Case> cases, bool quick) {
    if (quick) std::erase_if(cases, [](const Case& c) { return !c.shownQuick; });
    return cases;
}

template <typename Cells>
void append(std::vector<std::string>& row, const Cells& cells) {
    row.insert(row.end(), cells.begin(), cells.end());
}

DataTable startTable(std::string title, std::vector<std::string> first) {
    DataTable table{std::move(title), std::move(first), {}};
    append(table.head, errorHead());
    append(table.head, costHead());
    return table;
}

/// One comparison, with its truth beside it and its errors below.
Panel makePanel(const FigureFolder& folder, const Comparison& comparison) {
    Panel panel;
    panel.title = comparison.title;
    addComparison(panel, folder, comparison, writeTruth(folder, comparison), "LTC");
    panel.note = describe(comparison.errors);
    return panel;
}

/// `row` with the comparison's errors and costs after its first cells.
std::vector<std::string> makeRow(std::vector<std::string> row, const Comparison& comparison) {
    append(row, errorCells(comparison.errors));
    append(row, costCells(comparison));
    return row;
}

}  // namespace

Figure makeFloorFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                       Progress& progress) {
    Figure figure;
    figure.name = "floor";
    figure.title = "A rectangular light over a floor";
    figure.columns = 2;
    figure.caption = {
        "A floor of 20 m by 20 m of white metal under a rectangle of 8 m by 3 m and 1000 nits, "
        "which stands half a metre above it, 6 m behind its middle, and is not shown itself. On "
        "the left of each slider linearly transformed cosines with the table of one lobe, on the "
        "right GGX itself, ray-traced without shadows. Both are shown linear in radiance, the "
        "brightest of each pair at white.",
        "Below, the relative difference: red where LTC is too bright, blue where it is too dark, "
        "each at full strength from 50 % on; grey beside the floor. A smooth floor mirrors the "
        "light, and only the faint tails around the mirror image are off; in between, the BRDF's "
        "lobe at the distant, grazing floor has a shape that one transformed cosine cannot take."};
    DataTable table = startTable("Errors and costs by perceptual roughness", {"roughness"});
    const std::vector<double> all = roughnesses(quick);
    for (std::size_t i = 0; i < all.size(); ++i) {
        PartialProgress part(progress, i, all.size());
        const Comparison comparison = compareFloor(maker, all[i], Quality::standard, part);
        figure.panels.push_back(makePanel(folder, comparison));
        table.rows.push_back(makeRow({fmt::format("{:.2f}", all[i])}, comparison));
    }
    figure.tables.push_back(table);
    return figure;
}

Figure makeFailureFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                         Progress& progress) {
    Figure figure;
    figure.name = "failures";
    figure.title = "Where linearly transformed cosines are wrong";
    figure.columns = 2;
    figure.caption = {
        "The same floor in cases that are hard for LTC, with the table of one lobe. Each panel "
        "says what goes wrong there and why. Sliders, colours and columns are those of the "
        "floor's figure."};
    DataTable table = startTable("Errors and costs by case", {"case"});
    const std::vector<FailureCase> cases = shownCases(failureCases(), quick);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        PartialProgress part(progress, i, cases.size());
        const TracedPicture truth = maker.trace(cases[i].scene, cases[i].pathFactor, part);
        const Comparison comparison = compareScene(maker, cases[i].name, cases[i].title,
                                                   cases[i].scene, Quality::standard, truth);
        Panel panel = makePanel(folder, comparison);
        panel.note += " " + cases[i].cause;
        figure.panels.push_back(panel);
        table.rows.push_back(makeRow({cases[i].title}, comparison));
    }
    figure.tables.push_back(table);
    return figure;
}

Figure makeQualityFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                         Progress& progress) {
    Figure figure;
    figure.name = "quality";
    figure.title = "One lobe and two";
    figure.columns = 2;
    figure.caption = {
        "The floor once more: on the left of each panel's first slider the standard quality, one "
        "transformed cosine for each roughness and view, on that of the second the high quality, "
        "the sum of two; on the right of both GGX, ray-traced. The second lobe takes up what "
        "a single one has to leave out, at the cost of a second integral over the light."};
    DataTable table =
        startTable("Errors and costs by perceptual roughness and lobes", {"roughness", "lobes"});
    const std::vector<double> all = roughnesses(quick);
    for (std::size_t i = 0; i < all.size(); ++i) {
        PartialProgress part(progress, i, all.size());
        Panel panel;
        Picture truth;
        for (const Quality quality : {Quality::standard, Quality::high}) {
            const bool two = quality == Quality::high;
            Comparison comparison = compareFloor(maker, all[i], quality, part);
            if (!two) {
                panel.title = comparison.title;
                truth = writeTruth(folder, comparison);
            }
            comparison.name += two ? "_two_lobes" : "_one_lobe";
            const std::string label = two ? "two lobes" : "one lobe";
            addComparison(panel, folder, comparison, truth, label);
            panel.note += fmt::format("{}{}: {}", two ? " " : "", two ? "Two lobes" : "One lobe",
                                      describe(comparison.errors));
            table.rows.push_back(
                makeRow({fmt::format("{:.2f}", all[i]), two ? "2" : "1"}, comparison));
        }
        figure.panels.push_back(panel);
    }
    figure.tables.push_back(table);
    return figure;
}

Figure makeShapeFigure(const FigureFolder& folder, PictureMaker& maker, bool quick,
                       Progress& progress) {
    constexpr double kRoughness = 0.2;
    Figure figure;
    figure.name = "shapes";
    figure.title = "Every shape of light";
    figure.columns = 2;
    figure.caption = {fmt::format(
        "The floor of roughness {:.2f} under one light of each shape, of 1000 nits or of a picture "
        "of as many at most, with the table of one lobe. The light is in none of the compared "
        "pictures; the last picture of each panel shows it as the camera sees it. Sliders, colours "
        "and columns are those of the floor's figure. Beside the light's mirror image the floor is "
        "nearly dark: the relative difference there is of hardly any light, and the root mean "
        "square, which weighs by light, tells more.",
        kRoughness)};
    DataTable table = startTable("Errors and costs by shape", {"light"});
    const std::vector<ShapeCase> cases = shownCases(shapeCases(kRoughness), quick);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        PartialProgress part(progress, i, cases.size());
        const TracedPicture truth = maker.trace(cases[i].scene, 1, part);
        const Comparison comparison = compareScene(maker, cases[i].name, cases[i].title,
                                                   cases[i].scene, Quality::standard, truth);
        Panel panel = makePanel(folder, comparison);
        panel.pictures.emplace_back(
            "LTC with the light",
            writeWithLight(folder, comparison, maker.drawWithLight(cases[i].scene)));
        panel.note = cases[i].description + " " + panel.note;
        figure.panels.push_back(panel);
        table.rows.push_back(makeRow({cases[i].title}, comparison));
    }
    figure.tables.push_back(table);
    return figure;
}

}  // namespace polylume::figures
