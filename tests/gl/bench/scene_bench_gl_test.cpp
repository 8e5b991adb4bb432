// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/scene_bench.hpp"

#include <algorithm>
#include <cstring>

#include "bench/bench_lights.hpp"
#include "gl/support/gl_test.hpp"

namespace polylume::bench {
namespace {

class SceneBenchTest : public test::GlTest {};

TEST_P(SceneBenchTest, measuresPassesAndMemory) {
    scene::Scene scene = makeFloorScene(Model::oneLobe);
    for (const PolygonLight& light : makeLights(Shape::rectangle, 3).polygons) {
        scene.areaLights.push_back({"", light, ""});
    }
    RenderOptions options;
    options.size = {160, 90};
    Progress progress;
    const SceneResult result =
        runSceneBench(context(), scene, makeFloorCamera(), options, 6, Clock::automatic, progress);
    EXPECT_EQ(result.lightCount, 3);
    EXPECT_GT(result.lightingSeconds.median, 0.0);
    EXPECT_GT(result.frameSeconds.median, 0.0);
    EXPECT_FALSE(result.lists);
    EXPECT_GT(result.peakMemoryBytes, 1'000'000u);
    const auto lighting = std::ranges::find(result.passes, "lighting", &PassResult::name);
    ASSERT_NE(lighting, result.passes.end());
    EXPECT_GT(lighting->milliseconds.most, 0.0);
}

POLYLUME_ON_EVERY_BACKEND(SceneBenchTest);

TEST(PeakMemoryTest, seesWhatIsTouchedAndBeginsAnew) {
    constexpr std::size_t kSize = 200'000'000;
    beginPeakMemory();
    const std::size_t before = peakMemoryBytes();
    {
        std::vector<char> block(kSize);
        std::memset(block.data(), 1, block.size());
        EXPECT_GE(peakMemoryBytes() + 1'000'000, before + kSize);
    }
    if (!beginPeakMemory()) GTEST_SKIP() << "this system does not begin anew";
    EXPECT_LT(peakMemoryBytes(), before + kSize / 2);
}

}  // namespace
}  // namespace polylume::bench
