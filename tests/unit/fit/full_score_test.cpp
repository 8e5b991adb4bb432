// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/full_score.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/ggx.hpp"
#include "brdf/oren_nayar.hpp"
#include "fit/lobe_model.hpp"
#include "fit/prepared_model.hpp"
#include "fit/score_table.hpp"
#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"

namespace polylume::fit {
namespace {

/// At roughness 0 this is Lambert's BRDF, whose lobe is the clamped cosine.
const brdf::OrenNayar& lambert() {
    static const brdf::OrenNayar brdf;
    return brdf;
}

ltc::TableEntry tiltedEntry() {
    ltc::TableEntry entry;
    entry.lobes[0] = {0.8, 0.5, -0.3, 0.9};
    return entry;
}

TEST(FullScore, theRightLobeHasNoError) {
    const LobeErrors errors = placeErrors(lambert(), 0.0, 0.6, ltc::TableEntry(), {});
    EXPECT_NEAR(errors.l1.mean, 0.0, 1e-12);
    EXPECT_NEAR(errors.l2.mean, 0.0, 1e-12);
    EXPECT_NEAR(errors.polygonMean, 0.0, 1e-10);
    EXPECT_EQ(errors.leak.mean, 0.0);
}

TEST(FullScore, preparedModelIsTheModel) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggxTwoLobes);
    for (const double cosine : {1.0, 0.5, 0.05}) {
        const ltc::TableEntry entry = table.lookup(0.4, cosine);
        const PreparedModel model(entry);
        for (int i = 0; i < 200; ++i) {
            const double z = (i + 0.5) / 200.0;
            const double planar = std::sqrt(1.0 - z * z);
            const glm::dvec3 direction(planar * std::cos(2.4 * i), planar * std::sin(2.4 * i), z);
            const double expected = modelDensity(direction, entry);
            EXPECT_NEAR(model.density(direction), expected, 1e-13 * expected);
        }
    }
}

TEST(FullScore, polygonErrorIsThatOfTheClosedForms) {
    FullScoreOptions options;
    options.rectangleCount = 400;
    const ltc::TableEntry entry = tiltedEntry();
    const LobeErrors errors = placeErrors(lambert(), 0.0, 0.6, entry, options);
    PolygonErrors expected;
    for (const Rectangle& rectangle : randomRectangles(options.seed, options.rectangleCount)) {
        const ltc::Contour contour(rectangle.begin(), rectangle.end());
        const double truth = ltc::formFactor({&contour, 1});
        expected.add(truth, modelShare(rectangle, entry) - truth);
    }
    EXPECT_GT(expected.mean(), 0.2);
    // The noise of rectangles' edges among the points of the rule.
    EXPECT_NEAR(errors.polygonMean, expected.mean(), 0.003 * expected.mean());
    EXPECT_NEAR(errors.polygonOfSums, expected.ratioOfSums(), 0.003 * expected.ratioOfSums());
    EXPECT_NEAR(errors.polygonCount, expected.count, 2);
}

TEST(FullScore, reflectingLessIsAnErrorOfThatShare) {
    ltc::TableEntry entry;
    entry.albedo = 0.9;
    const LobeErrors errors = placeErrors(lambert(), 0.0, 0.6, entry, {});
    EXPECT_NEAR(errors.l1.mean, 0.1, 1e-9);
    EXPECT_NEAR(errors.l2.mean, 0.1, 1e-9);
    // All rectangles lose the same.
    EXPECT_NEAR(errors.polygonMean, 0.1, 1e-3);
    EXPECT_NEAR(errors.polygonOfSums, 0.1, 1e-3);
}

TEST(FullScore, leakIsWhatLiesBelowTheSurface) {
    const ltc::TableEntry one = tiltedEntry();
    const double share = ltc::upperShare(one.lobes[0]);
    EXPECT_NEAR(placeErrors(lambert(), 0.0, 0.6, one, {}).leak.mean, 1.0 - share, 1e-12);
    // Two lobes of weights share / H: of what both hold, the part above is 1.
    ltc::TableEntry two = one;
    two.lobeCount = 2;
    two.lobes[1] = ltc::Lobe();
    two.shares = {0.25, 0.75};
    const double whole = 0.25 / share + 0.75;
    EXPECT_NEAR(placeErrors(lambert(), 0.0, 0.6, two, {}).leak.mean, 1.0 - 1.0 / whole, 1e-12);
}

TEST(FullScore, theReferencesOwnErrorIsFarBelowTheScore) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    FullScoreOptions usual;
    usual.rectangleCount = 200;
    FullScoreOptions fine = usual;
    fine.resolution = 4 * usual.resolution;
    for (const double roughness : {0.07, 0.3, 0.7}) {
        for (const double cosine : {0.9, 0.3, 0.1}) {
            const ltc::TableEntry entry = table.lookup(roughness, cosine);
            const LobeErrors a = placeErrors(brdf::Ggx(), roughness, cosine, entry, usual);
            const LobeErrors b = placeErrors(brdf::Ggx(), roughness, cosine, entry, fine);
            EXPECT_NEAR(a.l1.mean, b.l1.mean, 0.005 * b.l1.mean + 1e-5);
            EXPECT_NEAR(a.l2.mean, b.l2.mean, 0.01 * b.l2.mean + 1e-5);
            EXPECT_NEAR(a.polygonMean, b.polygonMean, 0.02 * b.polygonMean + 1e-4);
        }
    }
}

TEST(FullScore, isTheSameForAnyNumberOfThreads) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggxTwoLobes);
    FullScoreOptions options;
    options.resolution = 16;
    options.rectangleCount = 4;
    Progress progress;
    options.threadCount = 1;
    const FullScore one = computeFullScore(brdf::Ggx(), table, options, progress);
    options.threadCount = 2;
    const FullScore two = computeFullScore(brdf::Ggx(), table, options, progress);
    ASSERT_EQ(one.rows.size(), 20u);
    ASSERT_EQ(two.rows.size(), 20u);
    for (std::size_t i = 0; i <= one.rows.size(); ++i) {
        const ScoreRow& a = i < one.rows.size() ? one.rows[i] : one.overall;
        const ScoreRow& b = i < two.rows.size() ? two.rows[i] : two.overall;
        EXPECT_EQ(a.lobesBetweenNodes.l1.mean, b.lobesBetweenNodes.l1.mean);
        EXPECT_EQ(a.lobesBetweenNodes.polygonMean, b.lobesBetweenNodes.polygonMean);
        EXPECT_EQ(a.lobesAtNodes.l2.mean, b.lobesAtNodes.l2.mean);
        EXPECT_EQ(a.reflectanceGrazing.albedo.mean, b.reflectanceGrazing.albedo.mean);
    }
}

TEST(FullScore, overallIsTheMeanOfRowsAndAgreesWithTheQuickScore) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    FullScoreOptions options;
    options.resolution = 64;
    options.rectangleCount = 4;
    Progress progress;
    const FullScore score = computeFullScore(brdf::Ggx(), table, options, progress);
    double sum = 0.0;
    double largest = 0.0;
    for (const ScoreRow& row : score.rows) {
        sum += row.lobesBetweenNodes.l1.mean / 20.0;
        largest = std::max(largest, row.lobesBetweenNodes.l1.largest);
    }
    EXPECT_NEAR(score.overall.lobesBetweenNodes.l1.mean, sum, 1e-12);
    EXPECT_EQ(score.overall.lobesBetweenNodes.l1.largest, largest);
    // Over half as many places along each axis.
    const TableScore quick = scoreTable(brdf::Ggx(), table);
    EXPECT_NEAR(score.overall.lobesBetweenNodes.l1.mean, quick.betweenNodes, 0.002);
    EXPECT_GE(score.overall.reflectanceGrazing.albedo.largest,
              score.overall.reflectanceBetweenNodes.albedo.largest);
}

}  // namespace
}  // namespace polylume::fit
