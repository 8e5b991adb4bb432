// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/summary.hpp"

#include <gtest/gtest.h>

namespace polylume::bench {
namespace {

TEST(SummaryTest, quartilesLieBetweenValues) {
    const Summary summary = summarize({4.0, 1.0, 3.0, 2.0});
    EXPECT_DOUBLE_EQ(summary.median, 2.5);
    EXPECT_DOUBLE_EQ(summary.lowerQuartile, 1.75);
    EXPECT_DOUBLE_EQ(summary.upperQuartile, 3.25);
    EXPECT_EQ(summary.least, 1.0);
    EXPECT_EQ(summary.most, 4.0);
}

TEST(SummaryTest, oneOutlierLeavesMedianAndQuartiles) {
    const Summary summary = summarize({5.0, 1000.0, 5.0, 5.0, 5.0, 5.0, 5.0});
    EXPECT_EQ(summary.median, 5.0);
    EXPECT_EQ(summary.upperQuartile, 5.0);
    EXPECT_EQ(summary.most, 1000.0);
}

TEST(SummaryTest, oneValueIsAllOfThem) {
    const Summary summary = summarize({7.0});
    EXPECT_EQ(summary.lowerQuartile, 7.0);
    EXPECT_EQ(summary.median, 7.0);
    EXPECT_EQ(summary.upperQuartile, 7.0);
    EXPECT_EQ(summarize({}).median, 0.0);
}

}  // namespace
}  // namespace polylume::bench
