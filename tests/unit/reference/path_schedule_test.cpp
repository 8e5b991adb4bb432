// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/path_schedule.hpp"

#include <gtest/gtest.h>

namespace polylume::reference {
namespace {

void finishAll(PathSchedule& schedule, int tileCount) {
    for (int tile = 0; tile < tileCount; ++tile) schedule.finish(tile);
}

TEST(PathScheduleTest, evenRoundsReachTheLastCountInStepsOfPowersOfTwoAndOneBetween) {
    PathSchedule schedule(3, 11);
    std::vector<int> counts;
    while (schedule.growEvenly()) {
        EXPECT_FALSE(schedule.isBetweenRounds());
        for (const int tile : {0, 1, 2})
            EXPECT_EQ(schedule.wantedCount(tile), schedule.wantedCount(0));
        finishAll(schedule, 3);
        EXPECT_TRUE(schedule.isBetweenRounds());
        counts.push_back(schedule.leastDoneCount());
    }
    EXPECT_EQ(counts, (std::vector<int>{1, 2, 3, 4, 6, 8, 11}));
}

TEST(PathScheduleTest, pathsGoWhereTheyLowerTheErrorMost) {
    PathSchedule schedule(4, 100);
    schedule.growEvenly();
    finishAll(schedule, 4);
    // The second tile alone brings the sum below what is allowed.
    ASSERT_TRUE(schedule.growWhereNoisy({{1.0, 50.0, 4.0, 0.0}, 25.0}));
    EXPECT_EQ(schedule.wantedCount(1), 2);
    for (const int tile : {0, 2, 3}) EXPECT_EQ(schedule.wantedCount(tile), 1);
    finishAll(schedule, 4);
    EXPECT_EQ(schedule.leastDoneCount(), 1);
    EXPECT_EQ(schedule.meanDoneCount(), 1.25);
    // An equal variance of fewer paths is cheaper to halve.
    ASSERT_TRUE(schedule.growWhereNoisy({{20.0, 20.0, 0.0, 0.0}, 30.0}));
    EXPECT_EQ(schedule.wantedCount(0), 2);
    EXPECT_EQ(schedule.wantedCount(1), 2);
}

TEST(PathScheduleTest, endsAtTheTargetOrWhereNoTileCanGrow) {
    PathSchedule schedule(2, 2);
    schedule.growEvenly();
    finishAll(schedule, 2);
    EXPECT_FALSE(schedule.growWhereNoisy({{1.0, 1.0}, 2.5}));
    // A tile without noise is left alone, however little is allowed.
    ASSERT_TRUE(schedule.growWhereNoisy({{1.0, 0.0}, 0.0}));
    EXPECT_EQ(schedule.wantedCount(0), 2);
    EXPECT_EQ(schedule.wantedCount(1), 1);
    finishAll(schedule, 2);
    EXPECT_FALSE(schedule.growWhereNoisy({{1.0, 0.0}, 0.5}));
}

TEST(PathScheduleTest, goesOnWhereARunWasStopped) {
    PathSchedule schedule(2, 8);
    schedule.set(0, 4, 4);
    schedule.set(1, 2, 4);
    EXPECT_FALSE(schedule.isBetweenRounds());
    EXPECT_EQ(schedule.leastDoneCount(), 2);
    schedule.finish(1);
    EXPECT_TRUE(schedule.isBetweenRounds());
}

}  // namespace
}  // namespace polylume::reference
