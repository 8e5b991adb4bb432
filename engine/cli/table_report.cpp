// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/table_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "fit/polygon_score.hpp"

namespace polylume::cli {
namespace {

using nlohmann::ordered_json;

std::string fieldLine(std::string_view name, std::string_view value) {
    return fmt::format("    {:<24}{}\n", name, value);
}

std::string sizeText(const ltc::Table& table) {
    const auto [columns, rows] = table.size();
    if (columns == 1) return fmt::format("1x{} nodes, over the view angle alone", rows);
    return fmt::format("{}x{} nodes, roughness by view angle", columns, rows);
}

std::string layoutText(const ltc::TableLayout& layout) {
    if (layout.classic) return "M^-1 itself, as two-texture tables have it";
    return layout.reference == ltc::LobeReference::mirror
               ? "lobes relative to a direction from the normal to the mirror direction"
               : "lobes relative to halfway between the normal and the mirror direction";
}

/// One line of the score, in percent but for the albedos.
std::string rowText(std::string_view name, const fit::ScoreRow& row) {
    const fit::LobeErrors& at = row.lobesAtNodes;
    const fit::LobeErrors& between = row.lobesBetweenNodes;
    return fmt::format(
        "{:>9} |{:7.2f}{:7.2f}{:7.2f} |{:7.2f}{:7.2f} |{:7.2f}{:7.2f} |{:6.2f}{:6.2f} "
        "|{:8.5f}{:8.5f} |{:8.5f}{:8.5f}\n",
        name, 100.0 * at.l1.mean, 100.0 * between.l1.mean, 100.0 * between.l1.largest,
        100.0 * at.l2.mean, 100.0 * between.l2.mean, 100.0 * at.polygonMean,
        100.0 * between.polygonMean, 100.0 * between.leak.mean, 100.0 * between.leak.largest,
        row.reflectanceBetweenNodes.albedo.largest, row.reflectanceBetweenNodes.fresnel.largest,
        row.reflectanceGrazing.albedo.largest, row.reflectanceGrazing.fresnel.largest);
}

ordered_json jsonOf(const fit::ErrorSummary& summary) {
    return {{"mean", summary.mean}, {"max", summary.largest}};
}

ordered_json jsonOf(const fit::LobeErrors& lobes, const fit::ReflectanceErrors& reflectance) {
    return {{"l1", jsonOf(lobes.l1)},
            {"l2", jsonOf(lobes.l2)},
            {"polygon",
             {{"mean", lobes.polygonMean},
              {"ratioOfSums", lobes.polygonOfSums},
              {"rectangles", lobes.polygonCount}}},
            {"leak", jsonOf(lobes.leak)},
            {"albedo", jsonOf(reflectance.albedo)},
            {"fresnel", jsonOf(reflectance.fresnel)}};
}

ordered_json jsonOf(const fit::ScoreRow& row) {
    return {{"atNodes", jsonOf(row.lobesAtNodes, row.reflectanceAtNodes)},
            {"betweenNodes", jsonOf(row.lobesBetweenNodes, row.reflectanceBetweenNodes)},
            {"grazing",
             {{"albedo", jsonOf(row.reflectanceGrazing.albedo)},
              {"fresnel", jsonOf(row.reflectanceGrazing.fresnel)}}}};
}

}  // namespace

std::string describeTable(const ltc::Table& table, std::string_view name) {
    std::string text = fmt::format("{}\n", name);
    text += fieldLine("size", sizeText(table));
    text += fieldLine("lobes", fmt::format("{}", table.layout().lobeCount));
    text += fieldLine("layout", layoutText(table.layout()));
    text += "\nattributes\n";
    for (const auto& [key, value] : table.attributes()) text += fieldLine(key, value);
    text += "\nvalues\n";
    const std::vector<std::string> names = table.layout().valueNames();
    for (std::size_t i = 0; i < names.size(); ++i) {
        float least = table.values()[i];
        float most = least;
        for (std::size_t at = i; at < table.values().size(); at += names.size()) {
            least = std::min(least, table.values()[at]);
            most = std::max(most, table.values()[at]);
        }
        text += fieldLine(names[i], fmt::format("{:.6g} to {:.6g}", least, most));
    }
    return text;
}

std::string scoreText(const ScoreTitle& title, const ltc::Table& table,
                      const fit::FullScore& score) {
    std::string text = fmt::format(
        "{} ({}, {} {}) against {}\n\n"
        "          |      L1 [%]         |    L2 [%]    |  polygon [%] |  leak [%]   "
        "|  albedo Fresnel |  albedo Fresnel\n"
        "roughness |  nodes between max  |  nodes betw. |  nodes betw. |  mean   max "
        "|    max to 85 deg|  max to 89.5 deg\n",
        title.table, sizeText(table), table.layout().lobeCount,
        table.layout().lobeCount == 1 ? "lobe" : "lobes", title.brdf);
    const bool hasRoughness = table.size().columns > 1 || table.attributes().contains("roughness");
    for (const fit::ScoreRow& row : score.rows) {
        text += rowText(hasRoughness ? fmt::format("{:.2f}", row.roughness) : "any", row);
    }
    text += rowText("all", score.overall);
    text += fmt::format(
        "\nf: BRDF times cosine; m: the table's lobes times its albedo; over the upper hemisphere, "
        "views from 0 to 85 degrees.\n"
        "L1: integral |f - m| / integral f. L2: sqrt(integral (f - m)^2 / integral f^2). Means "
        "over "
        "views.\n"
        "polygon: mean of |m - f| / f integrated over {} random rectangles, near, far and across "
        "the horizon, of those\n"
        "that catch at least {:g} % of the lobe. leak: share of the lobes below the surface before "
        "they are normalised.\n"
        "albedo, Fresnel: largest absolute error between nodes.\n",
        score.overall.lobesAtNodes.polygonCount + score.overall.lobesBetweenNodes.polygonCount,
        100.0 * fit::kLeastCaughtShare);
    return text;
}

std::string scoreJson(const ScoreTitle& title, const ltc::Table& table,
                      const fit::FullScore& score) {
    ordered_json rows = ordered_json::array();
    for (const fit::ScoreRow& row : score.rows) {
        ordered_json entry = {{"roughness", row.roughness}};
        entry.update(jsonOf(row));
        rows.push_back(entry);
    }
    const ordered_json object = {{"table", title.table},
                                 {"brdf", title.brdf},
                                 {"columns", table.size().columns},
                                 {"rows", table.size().rows},
                                 {"lobes", table.layout().lobeCount},
                                 {"overall", jsonOf(score.overall)},
                                 {"perRoughness", rows}};
    return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace polylume::cli
