// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/fit_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "brdf/ggx.hpp"
#include "core/error.hpp"
#include "fit/column_fit.hpp"
#include "fit/score_table.hpp"

namespace polylume::fit {
namespace {

class RecordedProgress : public Progress {
  public:
    void update(double fraction) override { fractions.push_back(fraction); }
    std::vector<double> fractions;
};

TEST(FitTable, givesTheSameBytesOnAnyNumberOfThreads) {
    Progress progress;
    FitOptions options{.size = 9, .resolution = 16, .threadCount = 1};
    const std::vector<std::byte> one = fitTable(brdf::Ggx(), options, progress).toRaw();
    for (const int threadCount : {2, 3, 0}) {
        options.threadCount = threadCount;
        EXPECT_EQ(fitTable(brdf::Ggx(), options, progress).toRaw(), one) << threadCount;
    }
    // Other work gives other bytes: the comparison sees something.
    options.resolution = 24;
    EXPECT_NE(fitTable(brdf::Ggx(), options, progress).toRaw(), one);
}

double largestDifference(const ltc::TableEntry& a, const ltc::TableEntry& b) {
    return std::max({std::abs(a.m11 - b.m11), std::abs(a.m13 - b.m13), std::abs(a.m31 - b.m31),
                     std::abs(a.m33 - b.m33), std::abs(a.albedo - b.albedo),
                     std::abs(a.fresnel - b.fresnel)});
}

TEST(FitTable, refitOfSomeColumnsAgreesWithTheShippedTable) {
    const ltc::Table& shipped = ltc::Table::builtinGgx();
    for (const int column : {0, 3, 17, 40, 63}) {
        const std::vector<ltc::TableEntry> refit =
            fitColumn(brdf::Ggx(), columnRoughness(column, shipped.size()), shipped.size(),
                      FitOptions{}.resolution);
        ASSERT_EQ(refit.size(), 64u);
        for (int row = 0; row < shipped.size(); ++row) {
            // The same on the machine that made it, but for float32; elsewhere libraries and fused
            // multiply-adds round differently (4e-7 measured).
            EXPECT_LE(largestDifference(refit[row], shipped.node(column, row)), 1e-5)
                << "column " << column << " row " << row;
        }
    }
    // The comparison tells neighbours apart.
    EXPECT_GT(largestDifference(shipped.node(17, 30), shipped.node(17, 31)), 1e-3);
}

TEST(FitTable, lobesFollowTheMirrorDirectionBetweenRowsToo) {
    // Half way between two rows a narrow lobe has to be near its own best fit: rows that are each
    // fitted alone give 0.052 as the mean here, all views looked up exactly 0.003.
    const ltc::Table& table = ltc::Table::builtinGgx();
    double sum = 0.0;
    constexpr int kCount = 50;
    for (int i = 0; i < kCount; ++i) {
        const double cosTheta = std::cos(85.0 * i / (kCount - 1) * std::numbers::pi / 180.0);
        sum += scoreEntry(brdf::Ggx(), 0.05, cosTheta, table.lookup(0.05, cosTheta));
    }
    EXPECT_LE(sum / kCount, 0.035);
}

TEST(FitTable, tellsItsProgressInRisingFractionsUpToOne) {
    RecordedProgress progress;
    fitTable(brdf::Ggx(), FitOptions{.size = 5, .resolution = 8}, progress);
    ASSERT_FALSE(progress.fractions.empty());
    EXPECT_TRUE(std::is_sorted(progress.fractions.begin(), progress.fractions.end()));
    EXPECT_GT(progress.fractions.front(), 0.0);
    EXPECT_EQ(progress.fractions.back(), 1.0);
}

TEST(FitTable, refusesOptionsOutOfRange) {
    Progress progress;
    const auto errorOf = [&](const FitOptions& options) -> std::string {
        try {
            fitTable(brdf::Ggx(), options, progress);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_THAT(errorOf({.size = 1}), ::testing::HasSubstr("found 1"));
    EXPECT_THAT(errorOf({.size = 100000}), ::testing::HasSubstr("found 100000"));
    EXPECT_THAT(errorOf({.resolution = 0}), ::testing::HasSubstr("found 0"));
    EXPECT_THAT(errorOf({.threadCount = -1}), ::testing::HasSubstr("and -1"));
}

}  // namespace
}  // namespace polylume::fit
