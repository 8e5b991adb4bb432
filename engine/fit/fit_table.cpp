// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/fit_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "fit/grid_fit.hpp"
#include "fit/score_table.hpp"
#include "parallel/threads.hpp"
#include "polylume/error.hpp"

namespace polylume::fit {
namespace {

GridPlan planOf(const brdf::Brdf& brdf, const FitOptions& options) {
    GridPlan plan;
    const bool viewOnly = options.viewOnly || !brdf.hasRoughness();
    plan.size = {viewOnly ? 1 : options.size, options.size};
    // A single column is stored relative to the mirror direction itself, which a rough lobe is far
    // from at grazing views.
    const bool isRough = viewOnly && brdf.hasRoughness() && options.viewRoughness > 0.5;
    plan.layout.reference = brdf.followsMirror() && !isRough ? ltc::LobeReference::mirror
                                                             : ltc::LobeReference::bisector;
    plan.layout.lobeCount = options.lobeCount;
    plan.layout.hasColor = brdf.hasColor();
    plan.resolution = options.resolution;
    plan.viewRoughness = brdf.hasRoughness() ? options.viewRoughness : 0.0;
    return plan;
}

/// The albedos by quadrature, not by the fit, so that the table's are exact at its nodes.
void setAlbedos(const brdf::Brdf& brdf, const GridPlan& plan, std::vector<ltc::TableNode>& nodes) {
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
        const double roughness = plan.roughness(static_cast<double>(i % plan.size.columns));
        const double cosThetaView = plan.cosThetaView(static_cast<double>(i / plan.size.columns));
        const brdf::Reflectance reflectance = brdf.reflectance(roughness, cosThetaView);
        if (!(reflectance.albedo <= ltc::Table::kMaxAlbedo)) {
            throw Error(concat("expected the BRDF \"", brdf.name(), "\" to reflect at most ",
                               ltc::Table::kMaxAlbedo, " times what arrives, found ",
                               reflectance.albedo, " at cos theta_v ", cosThetaView,
                               ": check its scale"));
        }
        nodes[i].albedo = reflectance.albedo;
        nodes[i].fresnel = reflectance.fresnel;
        if (brdf.hasColor()) nodes[i].color = brdf.albedoColor(roughness, cosThetaView);
    });
}

std::map<std::string, std::string> attributesOf(const brdf::Brdf& brdf, const GridPlan& plan,
                                                const FitOptions& options) {
    std::map<std::string, std::string> attributes = plan.layout.attributes();
    attributes["brdf"] = brdf.name();
    attributes["alphaFloor"] = formatNumber("%.9g", brdf.alphaFloor());
    attributes["solver"] = options.solver == Solver::lm ? "lm" : "moments";
    if (plan.size.columns == 1 && brdf.hasRoughness()) {
        attributes["roughness"] = formatNumber("%.9g", plan.viewRoughness);
    }
    return attributes;
}

ltc::Table withScore(const ltc::Table& table, const TableScore& score) {
    // Few enough digits to be the same on machines that round differently.
    return table.withAttributes(
        {{"scoreAtNodes", formatNumber("%.4f", score.atNodes)},
         {"scoreBetweenNodes", formatNumber("%.4f", score.betweenNodes)},
         {"scoreWorst", formatNumber("%.3f", score.worst)},
         {"scoreMeaning",
          "integral |f cos - albedo lobes| / albedo, mean over r 0.05 to 1, theta_v 0 to 85 "
          "degrees"}});
}

ltc::Table fitInArena(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress) {
    const GridPlan plan = planOf(brdf, options);
    const bool isLm = options.solver == Solver::lm;
    StepCounter counter(progress, (isLm ? fitGridStepCount(plan) : plan.size.columns) + 2);
    const auto step = [&] { counter.step(); };
    std::vector<ltc::TableNode> nodes =
        isLm ? fitGrid(brdf, plan, step) : fitGridByMoments(brdf, plan, step);
    setAlbedos(brdf, plan, nodes);
    step();
    std::vector<float> values;
    for (const ltc::TableNode& node : nodes) {
        const std::vector<float> packed = plan.layout.pack(node);
        values.insert(values.end(), packed.begin(), packed.end());
    }
    const ltc::Table table(plan.size, std::move(values), attributesOf(brdf, plan, options));
    const TableScore score = scoreTable(brdf, table);
    step();
    return withScore(table, score);
}

void checkOptions(const FitOptions& options) {
    if (options.size < ltc::Table::kMinSize || options.size > ltc::Table::kMaxSize) {
        throw Error(concat("expected a table size from ", ltc::Table::kMinSize, " to ",
                           ltc::Table::kMaxSize, ", found ", options.size, ": 64 is usual"));
    }
    if (options.lobeCount < 1 || options.lobeCount > ltc::kMaxLobeCount) {
        throw Error(
            concat("expected 1 to ", ltc::kMaxLobeCount, " lobes, found ", options.lobeCount));
    }
    if (!(options.viewRoughness >= 0.0 && options.viewRoughness <= 1.0)) {
        throw Error(concat("expected a roughness from 0 to 1, found ", options.viewRoughness));
    }
    if (options.resolution < 8 || options.threadCount < 0) {
        throw Error(
            concat("expected a fit resolution of at least 8 and a thread count of at least 0, ",
                   "found ", options.resolution, " and ", options.threadCount));
    }
}

}  // namespace

ltc::Table fitTable(const brdf::Brdf& brdf, const FitOptions& options, Progress& progress) {
    checkOptions(options);
    return runOnThreads(options.threadCount, [&] { return fitInArena(brdf, options, progress); });
}

}  // namespace polylume::fit
