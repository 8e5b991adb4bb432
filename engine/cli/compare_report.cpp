// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/compare_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace polylume::cli {
namespace {

using compare::LayerDifference;
using compare::LimitKind;
using compare::Verdict;

std::string_view flagOf(LimitKind kind) {
    switch (kind) {
        case LimitKind::relativeRmse:
            return "--max-rel-rmse";
        case LimitKind::maximum:
            return "--max-abs";
        default:
            return "--flip-max";
    }
}

std::string_view nameOf(PixelValues values) {
    return values == PixelValues::display ? "display" : "linear";
}

/// The layer's name with its channels, where they say more.
std::string titleOf(const LayerDifference& layer) {
    if (layer.channels.size() == 1 && layer.channels.front() == layer.name) return layer.name;
    std::string channels;
    for (const std::string& channel : layer.channels) {
        // Without the layer's name, which npos + 1 = 0 leaves whole where there is none.
        channels += (channels.empty() ? "" : ",") + channel.substr(channel.rfind('.') + 1);
    }
    return fmt::format("{} ({})", layer.name, channels);
}

std::string extremeText(const LayerDifference& layer) {
    const compare::ValueAt& at = layer.maximumAt;
    if (layer.maximum == 0.0) return "equal everywhere";
    return fmt::format("at ({}, {}), {}: {:.6g} in place of {:.6g}", at.x, at.y, at.channel,
                       at.test, at.reference);
}

nlohmann::ordered_json layerJson(const LayerDifference& layer) {
    // The library writes null for what is not finite.
    return {{"name", layer.name},
            {"channels", layer.channels},
            {"relativeRmse", layer.relativeRmse},
            {"rmse", layer.rmse},
            {"relativeMeanAbsolute", layer.relativeMeanAbsolute},
            {"meanAbsolute", layer.meanAbsolute},
            {"relativeBias", layer.relativeBias},
            {"bias", layer.bias},
            {"psnrDecibels", layer.psnr},
            {"maximum", layer.maximum},
            {"maximumAt",
             {{"x", layer.maximumAt.x},
              {"y", layer.maximumAt.y},
              {"channel", layer.maximumAt.channel},
              {"test", layer.maximumAt.test},
              {"reference", layer.maximumAt.reference}}}};
}

nlohmann::ordered_json flipJson(const compare::Comparison& comparison) {
    if (!comparison.flip) return nullptr;
    const compare::FlipSummary& flip = *comparison.flip;
    nlohmann::ordered_json json = {{"mean", flip.mean},
                                   {"weightedMedian", flip.weightedMedian},
                                   {"maximum", flip.maximum},
                                   {"maximumAt", {{"x", flip.x}, {"y", flip.y}}},
                                   {"pixelsPerDegree", comparison.pixelsPerDegree}};
    if (comparison.exposures) {
        json["exposures"] = {{"start", comparison.exposures->start},
                             {"stop", comparison.exposures->stop},
                             {"count", comparison.exposures->count}};
    }
    return json;
}

std::string dump(const nlohmann::ordered_json& json) {
    // A file's name may be no UTF-8.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string compareText(const CompareReport& report) {
    const compare::Comparison& comparison = report.comparison;
    std::string text =
        fmt::format("{} against {}: {}x{} pixels, {} values\n\n", report.test, report.reference,
                    comparison.width, comparison.height, nameOf(comparison.values));
    std::size_t width = 5;
    for (const LayerDifference& layer : comparison.layers) {
        width = std::max(width, titleOf(layer).size());
    }
    text += fmt::format("{:<{}}  {:>10}  {:>10}  {:>11}  {:>10}  {:>10}  {:>8}  largest\n", "layer",
                        width, "rel. RMSE", "RMSE", "rel. |diff|", "rel. bias", "bias", "PSNR, dB");
    for (const LayerDifference& layer : comparison.layers) {
        text += fmt::format(
            "{:<{}}  {:>10.4g}  {:>10.4g}  {:>11.4g}  {:>10.3g}  {:>10.3g}  {:>8.2f}  "
            "{:.4g} {}\n",
            titleOf(layer), width, layer.relativeRmse, layer.rmse, layer.relativeMeanAbsolute,
            layer.relativeBias, layer.bias, layer.psnr, layer.maximum, extremeText(layer));
    }
    if (comparison.flip) {
        const compare::FlipSummary& flip = *comparison.flip;
        text += fmt::format(
            "\n{}  mean {:.4f}, weighted median {:.4f}, largest {:.4f} at ({}, {}); {:g} "
            "pixels per degree",
            comparison.exposures ? "HDR-FLIP" : "FLIP", flip.mean, flip.weightedMedian,
            flip.maximum, flip.x, flip.y, comparison.pixelsPerDegree);
        if (comparison.exposures) {
            text += fmt::format(", {} exposure{} from {:+.2f} to {:+.2f} stops",
                                comparison.exposures->count,
                                comparison.exposures->count == 1 ? "" : "s",
                                comparison.exposures->start, comparison.exposures->stop);
        }
        text += '\n';
    }
    if (!report.verdicts.empty()) text += '\n';
    for (const Verdict& verdict : report.verdicts) text += describe(verdict) + '\n';
    if (!report.verdicts.empty()) text += allPassed(report.verdicts) ? "PASSED\n" : "FAILED\n";
    return text;
}

std::string compareJson(const CompareReport& report) {
    const compare::Comparison& comparison = report.comparison;
    nlohmann::ordered_json layers = nlohmann::ordered_json::array();
    for (const LayerDifference& layer : comparison.layers) layers.push_back(layerJson(layer));
    nlohmann::ordered_json limits = nlohmann::ordered_json::array();
    for (const Verdict& verdict : report.verdicts) {
        limits.push_back({{"flag", flagOf(verdict.kind)},
                          {"layer", verdict.layer},
                          {"limit", verdict.limit},
                          {"found", verdict.found},
                          {"passed", verdict.passed}});
    }
    const nlohmann::ordered_json json = {{"test", report.test},
                                         {"reference", report.reference},
                                         {"width", comparison.width},
                                         {"height", comparison.height},
                                         {"values", nameOf(comparison.values)},
                                         {"layers", layers},
                                         {"flip", flipJson(comparison)},
                                         {"limits", limits},
                                         {"passed", allPassed(report.verdicts)}};
    return dump(json);
}

std::string failureJson(const CompareCommand& command, std::string_view error) {
    return dump({{"test", command.test.string()},
                 {"reference", command.reference.string()},
                 {"error", error},
                 {"passed", false}});
}

std::string describe(const Verdict& verdict) {
    const char* measure = verdict.kind == LimitKind::meanFlip       ? "mean FLIP"
                          : verdict.kind == LimitKind::relativeRmse ? "relative RMSE"
                                                                    : "largest difference";
    return fmt::format("{} {:g}: {} {} {:.6g}, {}", flagOf(verdict.kind), verdict.limit,
                       verdict.layer, measure, verdict.found,
                       verdict.passed ? "within the limit" : "over the limit");
}

bool allPassed(const std::vector<Verdict>& verdicts) {
    return std::all_of(verdicts.begin(), verdicts.end(),
                       [](const Verdict& verdict) { return verdict.passed; });
}

}  // namespace polylume::cli
