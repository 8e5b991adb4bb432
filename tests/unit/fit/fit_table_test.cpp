// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/fit_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "brdf/registry.hpp"
#include "fit/grid_fit.hpp"
#include "fit/lobe_model.hpp"
#include "ltc/builtin_table.hpp"
#include "polylume/error.hpp"

namespace polylume::fit {
namespace {

class RecordedProgress : public Progress {
  public:
    void update(double fraction) override { fractions.push_back(fraction); }
    std::vector<double> fractions;
};

std::vector<std::byte> bytesOf(const FitOptions& options, const char* brdfName = "ggx") {
    Progress progress;
    return fitTable(*brdf::makeBrdf(brdfName), options, progress).toRaw();
}

TEST(FitTable, givesTheSameBytesOnAnyNumberOfThreads) {
    for (const Solver solver : {Solver::moments, Solver::lm}) {
        for (const int lobeCount : {1, 2}) {
            FitOptions options{.solver = solver,
                               .lobeCount = lobeCount,
                               .size = 9,
                               .resolution = 16,
                               .threadCount = 1};
            const std::vector<std::byte> one = bytesOf(options);
            for (const int threadCount : {2, 3, 0}) {
                options.threadCount = threadCount;
                EXPECT_EQ(bytesOf(options), one) << threadCount;
            }
            // Other work gives other bytes: the comparison sees something.
            options.resolution = 24;
            EXPECT_NE(bytesOf(options), one);
        }
    }
}

/// The largest difference of any value of a table's nodes.
double largestDifference(const ltc::Table& a, const ltc::Table& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        largest = std::max(largest, std::abs(static_cast<double>(a.values()[i]) - b.values()[i]));
    }
    return largest;
}

TEST(FitTable, refitAgreesWithTheShippedTable) {
    // The same on the machine that made it; elsewhere libraries and fused multiply-adds round
    // differently, and shear reaches 1.
    constexpr double kTolerance = 1e-4;
    Progress progress;
    const ltc::Table& shipped = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const ltc::Table refit = fitTable(*brdf::makeBrdf("ggx"), FitOptions{}, progress);
    EXPECT_LE(largestDifference(refit, shipped), kTolerance);
    EXPECT_EQ(refit.attributes(), shipped.attributes());
    const ltc::Table& diffuse = ltc::builtinTable(ltc::BuiltinTable::orenNayar);
    EXPECT_LE(
        largestDifference(fitTable(*brdf::makeBrdf("oren-nayar"), FitOptions{}, progress), diffuse),
        kTolerance);
    // The comparison tells tables apart.
    EXPECT_GT(largestDifference(diffuse, shipped), 0.1);
}

struct Shipped {
    ltc::BuiltinTable table;
    const char* brdf;
};

constexpr Shipped kShipped[] = {
    {ltc::BuiltinTable::ggx, "ggx"},           {ltc::BuiltinTable::ggxTwoLobes, "ggx"},
    {ltc::BuiltinTable::beckmann, "beckmann"}, {ltc::BuiltinTable::beckmannTwoLobes, "beckmann"},
    {ltc::BuiltinTable::burley, "burley"},     {ltc::BuiltinTable::orenNayar, "oren-nayar"},
    {ltc::BuiltinTable::charlie, "charlie"}};

TEST(FitTable, shippedTablesAreNearlyAsGoodBetweenNodesAsCellsFittedAlone) {
    for (const Shipped& shipped : kShipped) {
        const ltc::Table& table = ltc::builtinTable(shipped.table);
        const auto brdf = brdf::makeBrdf(shipped.brdf);
        double looked = 0.0;
        double alone = 0.0;
        for (const double roughness : {0.05, 0.31, 0.57, 0.83}) {
            for (const double degrees : {0.0, 23.0, 44.0, 61.0, 76.0, 85.0}) {
                const double cosThetaView = std::cos(degrees * std::numbers::pi / 180.0);
                const LobeSamples samples = sampleLobe(*brdf, roughness, cosThetaView, 32);
                const ltc::LobeAxis axis =
                    ltc::lobeAxis(table.layout().reference, roughness, cosThetaView);
                const ltc::TableNode node = fitAlone(samples, table.layout(), axis, degrees == 0.0);
                alone += lobeError(samples, table.layout().decode(node, roughness, cosThetaView));
                looked += lobeError(samples, table.lookup(roughness, cosThetaView));
            }
        }
        EXPECT_LE(looked, 1.15 * alone)
            << table.attributes().at("brdf") << " of " << table.layout().lobeCount;
        EXPECT_GT(looked, 0.0);
    }
}

TEST(FitTable, shippedAlbedosAreThoseOfTheBrdf) {
    for (const Shipped& shipped : kShipped) {
        const ltc::Table& table = ltc::builtinTable(shipped.table);
        const auto brdf = brdf::makeBrdf(shipped.brdf);
        for (const int column : {0, 7, 30, 63}) {
            for (const int row : {0, 21, 50, 62, 63}) {
                const brdf::Reflectance truth =
                    brdf->reflectance(table.roughness(column), table.cosThetaView(row));
                const ltc::TableEntry entry = table.entry(column, row);
                // The rounding of float32.
                EXPECT_NEAR(entry.albedo, truth.albedo, 2e-7 * (1.0 + truth.albedo));
                EXPECT_NEAR(entry.fresnel, truth.fresnel, 2e-7);
            }
        }
    }
}

TEST(FitTable, narrowLobesFollowTheMirrorDirectionBetweenNodes) {
    // The published tables have 0.089 here, and 0.006 at their nodes.
    for (const auto which : {ltc::BuiltinTable::ggx, ltc::BuiltinTable::ggxTwoLobes}) {
        const ltc::Table& table = ltc::builtinTable(which);
        double sum = 0.0;
        constexpr int kCount = 50;
        for (int i = 0; i < kCount; ++i) {
            const double cosTheta = std::cos(85.0 * i / (kCount - 1) * std::numbers::pi / 180.0);
            const LobeSamples samples = sampleLobe(*brdf::makeBrdf("ggx"), 0.05, cosTheta, 48);
            sum += lobeError(samples, table.lookup(0.05, cosTheta));
        }
        EXPECT_LE(sum / kCount, 0.01);
    }
}

TEST(FitTable, aViewOnlyTableHasOneColumnForAnyRoughness) {
    Progress progress;
    const auto ggx = brdf::makeBrdf("ggx");
    const FitOptions options{.size = 48, .viewOnly = true, .viewRoughness = 0.5};
    const ltc::Table table = fitTable(*ggx, options, progress);
    EXPECT_EQ(table.size().columns, 1);
    EXPECT_EQ(table.size().rows, 48);
    EXPECT_EQ(table.attributes().at("roughness"), "0.5");
    const ltc::Table& whole = ltc::builtinTable(ltc::BuiltinTable::ggx);
    for (const double cosThetaView : {1.0, 0.8, 0.5, 0.2}) {
        const LobeSamples samples = sampleLobe(*ggx, 0.5, cosThetaView, 32);
        const ltc::TableEntry entry = table.lookup(0.9, cosThetaView);
        EXPECT_EQ(entry.lobes[0].m11, table.lookup(0.1, cosThetaView).lobes[0].m11);
        EXPECT_LE(lobeError(samples, entry),
                  1.05 * lobeError(samples, whole.lookup(0.5, cosThetaView)));
    }
}

TEST(FitTable, twoLobesHoldOnToNarrowLobesInCoarseTables) {
    Progress progress;
    const auto ggx = brdf::makeBrdf("ggx");
    struct Case {
        int size;
        double roughness;
    };
    for (const Case& c : {Case{64, 0.1}, Case{16, 0.1}, Case{16, 0.3}, Case{32, 0.7}}) {
        FitOptions options{.size = c.size, .viewOnly = true, .viewRoughness = c.roughness};
        const auto errorOf = [&](int lobeCount) {
            options.lobeCount = lobeCount;
            const ltc::Table table = fitTable(*ggx, options, progress);
            return std::stod(table.attributes().at("scoreBetweenNodes"));
        };
        const double one = errorOf(1);
        // Where one lobe is all but exact, the wish for smoothness counts more with two: 1.23 times
        // at most here, where a start that lost the lobe had been 13 times as far.
        EXPECT_LE(errorOf(2), 1.3 * one) << c.size << " " << c.roughness;
    }
}

TEST(FitTable, sizesFromSmallToLargeGiveValidTables) {
    for (const int size : {16, 33, 128}) {
        Progress progress;
        const FitOptions options{.solver = Solver::moments, .size = size, .resolution = 16};
        const ltc::Table table = fitTable(*brdf::makeBrdf("ggx"), options, progress);
        EXPECT_EQ(table.size().rows, size);
    }
}

TEST(FitTable, tellsItsProgressInRisingFractionsUpToOne) {
    RecordedProgress progress;
    fitTable(*brdf::makeBrdf("ggx"), FitOptions{.size = 5, .resolution = 8}, progress);
    ASSERT_FALSE(progress.fractions.empty());
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_GT(progress.fractions.front(), 0.0);
    EXPECT_EQ(progress.fractions.back(), 1.0);
}

TEST(FitTable, refusesOptionsOutOfRange) {
    Progress progress;
    const auto errorOf = [&](const FitOptions& options) -> std::string {
        try {
            fitTable(*brdf::makeBrdf("ggx"), options, progress);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(errorOf({.size = 1}), ::testing::HasSubstr("found 1"));
    EXPECT_THAT(errorOf({.size = 100000}), ::testing::HasSubstr("found 100000"));
    EXPECT_THAT(errorOf({.resolution = 0}), ::testing::HasSubstr("found 0"));
    EXPECT_THAT(errorOf({.threadCount = -1}), ::testing::HasSubstr("and -1"));
    EXPECT_THAT(errorOf({.lobeCount = 3}), ::testing::HasSubstr("found 3"));
    EXPECT_THAT(errorOf({.viewRoughness = 1.5}), ::testing::HasSubstr("found 1.5"));
}

}  // namespace
}  // namespace polylume::fit
