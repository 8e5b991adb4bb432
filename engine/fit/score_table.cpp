// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/score_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "fit/fit_table.hpp"
#include "fit/lobe_model.hpp"

namespace polylume::fit {
namespace {

constexpr double kMinRoughness = 0.05;
constexpr double kMaxThetaDegrees = 85.0;

double cosDegrees(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180.0);
}

}  // namespace

double scoreEntry(const brdf::Brdf& brdf, double roughness, double cosThetaView,
                  const ltc::TableEntry& entry) {
    constexpr int kResolution = 64;
    const LobeSamples samples = sampleLobe(brdf, roughness, cosThetaView, kResolution);
    const double scale = entry.albedo / brdf.reflectance(roughness, cosThetaView).albedo;
    double sum = 0.0;
    for (const LobeSamples::Point& point : samples.points) {
        const double lobe = normalisedLobe(point.direction, entry, nullptr);
        sum += point.weight * std::abs(1.0 - scale * lobe / point.target);
    }
    return sum;
}

TableScore scoreTable(const brdf::Brdf& brdf, const ltc::Table& table, int gridSize) {
    struct Place {
        double roughness;
        double cosThetaView;
    };
    std::vector<Place> places;
    for (int row = 0; row < table.size(); ++row) {
        for (int column = 0; column < table.size(); ++column) {
            const Place place{columnRoughness(column, table.size()),
                              rowCosThetaView(row, table.size())};
            const bool inRange = place.roughness >= kMinRoughness &&
                                 place.cosThetaView >= cosDegrees(kMaxThetaDegrees);
            if (inRange) places.push_back(place);
        }
    }
    const std::size_t nodeCount = places.size();
    for (int i = 0; i < gridSize; ++i) {
        for (int j = 0; j < gridSize; ++j) {
            const double u = static_cast<double>(i) / (gridSize - 1);
            const double v = static_cast<double>(j) / (gridSize - 1);
            places.push_back(
                {kMinRoughness + (1.0 - kMinRoughness) * u, cosDegrees(kMaxThetaDegrees * v)});
        }
    }

    std::vector<double> errors(places.size());
    std::vector<double> albedoErrors(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const Place& place = places[i];
        const ltc::TableEntry entry = table.lookup(place.roughness, place.cosThetaView);
        errors[i] = scoreEntry(brdf, place.roughness, place.cosThetaView, entry);
        const double albedo = brdf.reflectance(place.roughness, place.cosThetaView).albedo;
        albedoErrors[i] = std::abs(entry.albedo - albedo);
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
    }
    return score;
}

}  // namespace polylume::fit
