// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/score_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ltc/builtin_table.hpp"

namespace polylume::fit {
namespace {

TEST(ScoreGrid, spansTheRange) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const std::vector<double> roughnesses = scoredRoughnesses(table, kScoredRoughnessCount);
    ASSERT_EQ(roughnesses.size(), 20u);
    EXPECT_DOUBLE_EQ(roughnesses.front(), 0.05);
    EXPECT_DOUBLE_EQ(roughnesses[1], 0.1);
    EXPECT_DOUBLE_EQ(roughnesses.back(), 1.0);
    const std::vector<double> views = scoredViews(0.0, kMostScoredDegrees, kScoredViewCount);
    ASSERT_EQ(views.size(), 35u);
    EXPECT_EQ(views.front(), 1.0);
    EXPECT_NEAR(views[1], std::cos(2.5 * std::acos(-1.0) / 180.0), 1e-15);
    EXPECT_NEAR(views.back(), cosDegrees(85.0), 1e-15);
}

TEST(ScoreGrid, nodesAreNodesInRangeAndComeOnce) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const std::vector<double> views = scoredViews(0.0, kMostScoredDegrees, kScoredViewCount);
    for (const double roughness : scoredRoughnesses(table, kScoredRoughnessCount)) {
        const std::vector<ScorePlace> nodes = nodesNear(table, roughness, views);
        EXPECT_GT(nodes.size(), 20u);
        double previous = 2.0;
        for (const ScorePlace& node : nodes) {
            const double column = node.roughness * 63.0;
            const double row = table.layout().viewCoordinate(node.cosThetaView) * 63.0;
            EXPECT_NEAR(column, std::round(column), 1e-9);
            EXPECT_NEAR(row, std::round(row), 1e-9);
            EXPECT_NEAR(node.roughness, roughness, 0.5001 / 63.0 + 0.014);
            EXPECT_GE(node.roughness, kLeastScoredRoughness);
            EXPECT_GE(node.cosThetaView, cosDegrees(kMostScoredDegrees));
            EXPECT_LT(node.cosThetaView, previous);
            previous = node.cosThetaView;
        }
    }
}

}  // namespace
}  // namespace polylume::fit
