// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/score_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace polylume::fit {

double cosDegrees(double degrees) {
    return std::cos(degrees * std::numbers::pi / 180.0);
}

std::vector<double> scoredRoughnesses(const ltc::Table& table, int count) {
    if (table.size().columns == 1) {
        const auto found = table.attributes().find("roughness");
        if (found == table.attributes().end()) return {0.0};
        return {std::clamp(std::strtod(found->second.c_str(), nullptr), 0.0, 1.0)};
    }
    std::vector<double> roughnesses;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        roughnesses.push_back(kLeastScoredRoughness + (1.0 - kLeastScoredRoughness) * share);
    }
    return roughnesses;
}

std::vector<double> scoredViews(double firstDegrees, double lastDegrees, int count) {
    std::vector<double> cosines;
    for (int i = 0; i < count; ++i) {
        const double share = static_cast<double>(i) / (count - 1);
        cosines.push_back(cosDegrees(firstDegrees + (lastDegrees - firstDegrees) * share));
    }
    return cosines;
}

std::vector<ScorePlace> nodesNear(const ltc::Table& table, double roughness,
                                  const std::vector<double>& cosThetaViews) {
    const auto [columns, rows] = table.size();
    double nodeRoughness = roughness;
    if (columns > 1) {
        // The first column in range, where the nearest is not.
        const double least = std::ceil(kLeastScoredRoughness * (columns - 1) - 1e-9);
        nodeRoughness = table.roughness(std::max(std::round(roughness * (columns - 1)), least));
    }
    std::vector<ScorePlace> places;
    int previous = -1;
    for (const double cosThetaView : cosThetaViews) {
        const double coordinate = table.layout().viewCoordinate(cosThetaView);
        int row = static_cast<int>(std::lround(coordinate * (rows - 1)));
        while (row > 0 && table.cosThetaView(row) < cosDegrees(kMostScoredDegrees)) --row;
        if (row == previous) continue;
        previous = row;
        places.push_back({nodeRoughness, table.cosThetaView(row)});
    }
    return places;
}

}  // namespace polylume::fit
