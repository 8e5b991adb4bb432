// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/score_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fit/lobe_model.hpp"
#include "fit/score_grid.hpp"

namespace polylume::fit {
namespace {

/// The nodes in range, then the grid.
std::vector<ScorePlace> placesOf(const ltc::Table& table, int gridSize, std::size_t& nodeCount) {
    const bool isSingleColumn = table.size().columns == 1;
    const std::vector<double> roughnesses = scoredRoughnesses(table, gridSize);
    std::vector<ScorePlace> places;
    for (int row = 0; row < table.size().rows; ++row) {
        for (int column = 0; column < table.size().columns; ++column) {
            const double roughness = isSingleColumn ? roughnesses.front() : table.roughness(column);
            const ScorePlace place{roughness, table.cosThetaView(row)};
            const bool inRange = (isSingleColumn || roughness >= kLeastScoredRoughness) &&
                                 place.cosThetaView >= cosDegrees(kMostScoredDegrees);
            if (inRange) places.push_back(place);
        }
    }
    nodeCount = places.size();
    for (const double roughness : roughnesses) {
        for (const double cosThetaView : scoredViews(0.0, kMostScoredDegrees, gridSize)) {
            places.push_back({roughness, cosThetaView});
        }
    }
    return places;
}

}  // namespace

double scoreEntry(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                  const ltc::TableEntry& entry) {
    constexpr int kResolution = 64;
    const LobeSamples samples = sampleLobe(brdf, roughness, cosThetaView, kResolution);
    return lobeError(samples, entry, entry.albedo / samples.albedo);
}

TableScore scoreTable(const brdf::Brdf& brdf, const ltc::Table& table, int gridSize) {
    std::size_t nodeCount = 0;
    const std::vector<ScorePlace> places = placesOf(table, gridSize, nodeCount);
    std::vector<double> errors(places.size());
    std::vector<double> albedoErrors(places.size());
    std::vector<double> fresnelErrors(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const ScorePlace& place = places[i];
        const ltc::TableEntry entry = table.lookup(place.roughness, place.cosThetaView);
        errors[i] = scoreEntry(brdf, place.roughness, place.cosThetaView, entry);
        if (i < nodeCount) return;  // Exact there, as the fit makes them.
        const brdf::Reflectance truth = brdf.reflectance(place.roughness, place.cosThetaView);
        albedoErrors[i] = std::abs(entry.albedo - truth.albedo);
        fresnelErrors[i] = std::abs(entry.fresnel - truth.fresnel);
    });

    // Summed in a fixed order, so that the score is the same for any number of threads.
    TableScore score;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i < nodeCount) {
            score.atNodes += errors[i] / static_cast<double>(nodeCount);
            continue;
        }
        score.betweenNodes += errors[i] / static_cast<double>(places.size() - nodeCount);
        score.worst = std::max(score.worst, errors[i]);
        score.albedoError = std::max(score.albedoError, albedoErrors[i]);
        score.fresnelError = std::max(score.fresnelError, fresnelErrors[i]);
    }
    return score;
}

}  // namespace polylume::fit
