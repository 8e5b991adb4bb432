// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/lighting_bench.hpp"

#include <cmath>

#include "gl/support/gl_test.hpp"
#include "support/error_of.hpp"

namespace polylume::bench {
namespace {

class LightingBenchTest : public test::GlTest {
  protected:
    static BenchOptions smallOptions() {
        BenchOptions options;
        options.size = {160, 90};
        options.repeatCount = 3;
        // Other tests run at the same time.
        options.clock = Clock::processor;
        options.cases = {{Shape::disk, Model::twoLobes}, {Shape::rectangle, Model::oneLobe}};
        options.sweepCounts = {1, 8};
        return options;
    }
};

void expectRate(const Rate& rate) {
    EXPECT_TRUE(std::isfinite(rate.perSecond.median));
    // A rasteriser of one core makes more than that.
    EXPECT_GT(rate.perSecond.median, 1e8) << rate.way;
    EXPECT_LE(rate.perSecond.lowerQuartile, rate.perSecond.upperQuartile);
    EXPECT_FALSE(rate.way.empty());
}

TEST_P(LightingBenchTest, measuresWhatItIsAskedFor) {
    Progress progress;
    const BenchResult result = runLightingBench(context(), smallOptions(), progress);
    EXPECT_EQ(result.repeatCount, 3);
    EXPECT_EQ(result.clock, "CPU time over threads");
    ASSERT_EQ(result.cases.size(), 2u);
    for (const CaseResult& one : result.cases) {
        EXPECT_GT(one.nanoseconds.median, 0.0);
        EXPECT_GT(one.floor.nanoseconds, 0.0);
        EXPECT_EQ(one.ratio, one.nanoseconds.median / one.floor.nanoseconds);
        EXPECT_EQ(one.operations, operationsPerLight(one.which.shape, one.which.model));
    }
    ASSERT_EQ(result.textbooks.size(), kTextbooks.size());
    for (const TextbookResult& textbook : result.textbooks) {
        EXPECT_GT(textbook.ratio.median, 0.0);
    }
    ASSERT_EQ(result.sweep.size(), 2u);
    // Eight lights take longer than one, if less than eight times as long: pixels cost, too.
    EXPECT_GT(result.sweep[1].milliseconds.median, result.sweep[0].milliseconds.median);
    EXPECT_GT(result.sweep[1].textbookMilliseconds.median,
              result.sweep[0].textbookMilliseconds.median);
    expectRate(result.machine.operations);
    expectRate(result.machine.sharedBytes);
    expectRate(result.machine.streamBytes);
}

TEST_P(LightingBenchTest, theFloorLiesBelowWhatWasMeasured) {
    BenchOptions options = smallOptions();
    options.size = {320, 180};
    options.cases = {{Shape::rectangle, Model::oneLobe}, {Shape::polygon16, Model::oneLobe}};
    options.sweepCounts.clear();
    Progress progress;
    for (const CaseResult& one : runLightingBench(context(), options, progress).cases) {
        // Not by rights, since a pass could have less to do than its shader says, but every one has
        // been well above; a floor that was counted or measured ten times off shows here.
        EXPECT_GT(one.ratio, 1.0) << infoOf(one.which.shape).name;
        EXPECT_LT(one.ratio, 10.0) << infoOf(one.which.shape).name;
    }
}

TEST_P(LightingBenchTest, saysWhatIsWrongWithOptions) {
    Progress progress;
    const auto error = [&](const BenchOptions& options) {
        return test::errorOf([&] { runLightingBench(context(), options, progress); });
    };
    BenchOptions options;
    options.size.x = 0;
    EXPECT_NE(error(options).find("found 0x720"), std::string::npos);
    options = {};
    options.repeatCount = 0;
    EXPECT_NE(error(options).find("1 repeat or more, found 0"), std::string::npos);
    options = {};
    options.sweepCounts = {65};
    EXPECT_NE(error(options).find("1 to 64 lights to sweep over, found 65"), std::string::npos);
}

POLYLUME_ON_EVERY_BACKEND(LightingBenchTest);

}  // namespace
}  // namespace polylume::bench
