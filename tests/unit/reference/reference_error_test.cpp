// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <cmath>

#include "reference_scenes.hpp"
#include "support/error_of.hpp"
#include "support/test_scenes.hpp"

// What a run says of its own error, and what it refuses.
namespace polylume::reference {
namespace {

using ::testing::HasSubstr;

/// A half smooth floor under a light that a blocker hides a part of: all kinds of noise.
scene::Scene makeNoisyScene() {
    scene::Scene scene = test::makeScene(test::makeFloor(3.0f), 0.4f, 0.5f, glm::vec3(0.7f));
    testing::addMesh(scene, testing::rectangleMesh({0.2f, 0.8f, 0}, {0.5f, 0, 0}, {0, 0, 0.4f}),
                     testing::lambertMaterial(glm::vec3(0.5f)));
    return scene;
}

ReferenceOptions makeNoisyOptions(int pathCount) {
    ReferenceOptions options = testing::plainOptions({20, 15}, pathCount);
    options.shadows = true;
    options.extraLights.polygons = {
        testing::rectangleLight({0, 1.5f, -1}, {1, 0, 0}, {0, 0.3f, 0.5f}, glm::vec3(1000.0f))};
    return options;
}

/// Of lights of all other shapes.
ReferenceOptions makeRoundOptions(int pathCount) {
    ReferenceOptions options = makeNoisyOptions(pathCount);
    options.extraLights.polygons[0].texture =
        testing::makePicture({4, 3}, {-1, 1.2f, -1.5f}, {2, 0, 0}, {0, 0.6f, 1});
    options.extraLights.spheres = {{{0.8f, 0.5f, -0.4f}, 0.2f, glm::vec3(2000.0f)}};
    options.extraLights.tubes = {{{-1, 1.0f, 0.6f}, {1, 1.2f, 0.4f}, 0.05f, glm::vec3(3000.0f)}};
    return options;
}

const scene::Camera kCamera = test::makeCamera({0, 2, 3}, {0, 0, 0}, 0.6f);

void expectErrorToBeTheSpread(ReferenceOptions options) {
    constexpr int kSeedCount = 32;
    const scene::Scene scene = makeNoisyScene();
    const std::size_t pixelCount = 20 * 15;
    std::vector<double> sum(pixelCount), squares(pixelCount), claimed(pixelCount);
    for (int seed = 0; seed < kSeedCount; ++seed) {
        options.seed = static_cast<std::uint32_t>(seed);
        const FloatImage image = testing::trace(scene, kCamera, options);
        for (std::size_t i = 0; i < pixelCount; ++i) {
            const double value = testing::color(image, i).r;
            const double deviation = testing::layer(image, "standardError", i).r;
            sum[i] += value;
            squares[i] += value * value;
            claimed[i] += deviation * deviation / kSeedCount;
        }
    }
    double ratioSum = 0.0;
    int count = 0, outside = 0;
    for (std::size_t i = 0; i < pixelCount; ++i) {
        if (!(claimed[i] > 0.0)) continue;
        const double mean = sum[i] / kSeedCount;
        const double variance = (squares[i] - kSeedCount * mean * mean) / (kSeedCount - 1);
        const double ratio = variance / claimed[i];
        ratioSum += ratio;
        ++count;
        // 99.9 % of chi-square with 31 degrees of freedom, over 31; widened by a tenth for the
        // spread of what is claimed.
        if (!(ratio > 0.9 * 0.437 && ratio < 1.1 * 1.970)) ++outside;
    }
    EXPECT_GT(count, 250);
    // The mean of `count` ratios of deviation sqrt(2 / 31) each, 4 deviations.
    EXPECT_NEAR(ratioSum / count, 1.0, 4.0 * std::sqrt(2.0 / 31.0 / count) + 0.01);
    // 0.1 % on either side for normal estimates; those of few paths at shadow borders are less so.
    EXPECT_LE(outside, count / 50);
    ::testing::Test::RecordProperty("mean ratio", std::to_string(ratioSum / count));
}

TEST(StandardErrorTest, isTheSpreadOverSeeds) {
    expectErrorToBeTheSpread(makeNoisyOptions(64));
}

TEST(StandardErrorTest, isTheSpreadOverSeedsUnderRoundAndTexturedLights) {
    expectErrorToBeTheSpread(makeRoundOptions(64));
}

TEST(StandardErrorTest, fallsFasterThanByTheRootOfThePaths) {
    const scene::Scene scene = makeNoisyScene();
    const auto errorOf = [&](const ReferenceOptions& options) {
        ReferenceTracer tracer(scene, kCamera, options);
        Progress progress;
        tracer.run(progress);
        return tracer.relativeError();
    };
    // Sixteen times the paths: a quarter of the error by the root; measured about a sixth.
    EXPECT_LT(errorOf(makeNoisyOptions(1024)) / errorOf(makeNoisyOptions(64)), 0.2);
    EXPECT_LT(errorOf(makeRoundOptions(1024)) / errorOf(makeRoundOptions(64)), 0.2);
}

TEST(StandardErrorTest, theRelativeErrorIsThatOfThePicture) {
    const scene::Scene scene = makeNoisyScene();
    ReferenceTracer tracer(scene, kCamera, makeNoisyOptions(64));
    Progress progress;
    tracer.run(progress);
    const FloatImage image = tracer.picture().image;
    double sum = 0.0, squares = 0.0;
    const std::size_t pixelCount = image.pixels.size() / image.channelCount();
    for (std::size_t i = 0; i < pixelCount; ++i) {
        const glm::dvec3 deviation = testing::layer(image, "standardError", i);
        const glm::dvec3 value = testing::color(image, i);
        sum += value.r + value.g + value.b;
        squares += glm::dot(deviation, deviation);
    }
    const double count = 3.0 * static_cast<double>(pixelCount);
    EXPECT_NEAR(tracer.relativeError(), std::sqrt(squares / count) / (sum / count), 1e-6);
}

TEST(TargetErrorTest, endsTheRunBelowIt) {
    const scene::Scene scene = makeNoisyScene();
    ReferenceOptions options = makeNoisyOptions(1 << 16);
    int last = 0;
    for (const double target : {0.2, 0.05, 0.02}) {
        options.targetError = target;
        ReferenceTracer tracer(scene, kCamera, options);
        Progress progress;
        EXPECT_TRUE(tracer.run(progress));
        EXPECT_LT(tracer.relativeError(), target);
        EXPECT_LT(tracer.pathCount(), options.pathCount);
        EXPECT_GE(tracer.pathCount(), last);
        last = tracer.pathCount();
    }
    EXPECT_GT(last, 16);
}

TEST(TargetErrorTest, whereThePathsGoDoesNotShiftThePicture) {
    const scene::Scene scene = makeNoisyScene();
    const auto imageOf = [&](const ReferenceOptions& options) {
        ReferenceTracer tracer(scene, kCamera, options);
        Progress progress;
        tracer.run(progress);
        return tracer.picture().image;
    };
    const FloatImage truth = imageOf(makeNoisyOptions(1 << 14));
    double sum = 0.0, difference = 0.0, variance = 0.0, square = 0.0;
    constexpr int kSeedCount = 16;
    for (int seed = 1; seed <= kSeedCount; ++seed) {
        ReferenceOptions options = makeNoisyOptions(1 << 16);
        options.targetError = 0.03;
        options.seed = static_cast<std::uint32_t>(seed);
        const FloatImage image = imageOf(options);
        for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
            const glm::dvec3 deviation = testing::layer(image, "standardError", i);
            const glm::dvec3 off = testing::color(image, i) - testing::color(truth, i);
            const glm::dvec3 value = testing::color(truth, i);
            sum += value.r + value.g + value.b;
            difference += off.r + off.g + off.b;
            square += glm::dot(off, off);
            // The channels of a pixel share their paths.
            const double ofAll = deviation.r + deviation.g + deviation.b;
            variance += ofAll * ofAll;
        }
    }
    EXPECT_LT(std::abs(difference), 3.0 * std::sqrt(variance));
    const double count = 3.0 * static_cast<double>(truth.width) * truth.height * kSeedCount;
    EXPECT_NEAR(std::sqrt(square / count) / (sum / count), 0.03, 0.01);
}

TEST(TargetErrorTest, thePathCountIsTheMost) {
    const scene::Scene scene = makeNoisyScene();
    ReferenceOptions options = makeNoisyOptions(33);
    options.targetError = 1e-9;
    ReferenceTracer tracer(scene, kCamera, options);
    Progress progress;
    EXPECT_TRUE(tracer.run(progress));
    EXPECT_EQ(tracer.pathCount(), 48);  // Rounded up to whole paths of 16 replicates.
}

TEST(TargetErrorTest, aBlackPictureHasNoError) {
    const scene::Scene scene = makeNoisyScene();
    ReferenceOptions options = makeNoisyOptions(64);
    options.extraLights = {};
    options.targetError = 0.01;
    ReferenceTracer tracer(scene, kCamera, options);
    Progress progress;
    EXPECT_TRUE(tracer.run(progress));
    EXPECT_EQ(tracer.relativeError(), 0.0);
}

TEST(ProgressTest, neverFallsAndEndsAtOne) {
    struct Recorder : Progress {
        double last = 0.0;
        bool fell = false;
        void update(double fraction) override {
            fell = fell || fraction < last || !(fraction <= 1.0);
            last = fraction;
        }
    };
    const scene::Scene scene = makeNoisyScene();
    ReferenceOptions options = makeNoisyOptions(256);
    ReferenceTracer tracer(scene, kCamera, options);
    Recorder recorder;
    tracer.run(recorder);
    EXPECT_FALSE(recorder.fell);
    EXPECT_EQ(recorder.last, 1.0);
}

struct BadOption {
    std::string expected;
    std::function<void(ReferenceOptions&)> apply;
};

TEST(ReferenceOptionsTest, badOnesAreRefused) {
    const scene::Scene scene = makeNoisyScene();
    const std::vector<BadOption> cases = {
        {"1x1 pixel or more, found 0x15", [](ReferenceOptions& o) { o.size.x = 0; }},
        {"found 20x-3", [](ReferenceOptions& o) { o.size.y = -3; }},
        {"a number of samples from 1", [](ReferenceOptions& o) { o.sampleCount = 0; }},
        {"found 65537", [](ReferenceOptions& o) { o.sampleCount = 65537; }},
        {"a number of paths from 1", [](ReferenceOptions& o) { o.pathCount = 0; }},
        {"found 2147483647", [](ReferenceOptions& o) { o.pathCount = 2147483647; }},
        {"a depth from 1", [](ReferenceOptions& o) { o.depth = 0; }},
        {"a depth from 1 to", [](ReferenceOptions& o) { o.depth = 100000; }},
        {"shadows where the depth is above 1",
         [](ReferenceOptions& o) { o.depth = 2, o.shadows = false; }},
        {"a target error above 0, found 0", [](ReferenceOptions& o) { o.targetError = 0.0; }},
        {"a target error above 0", [](ReferenceOptions& o) { o.targetError = -0.1; }},
        {"a target error above 0, found nan", [](ReferenceOptions& o) { o.targetError = NAN; }},
        {"AOV", [](ReferenceOptions& o) { o.aovs = {"colour"}; }},
        {"radiance of polygon light 0",
         [](ReferenceOptions& o) { o.extraLights.polygons[0].radiance.y = -1.0f; }},
        {"not to cross itself",
         [](ReferenceOptions& o) {
             o.extraLights.polygons[0].contours = {
                 {{-1, 1, -1}, {1, 1, 1}, {1, 1, -1}, {-1, 1, 1}, {0, 1, 3}}};
         }},
        {"a finite radius of 0 or more of sphere light 0",
         [](ReferenceOptions& o) {
             o.extraLights.spheres = {{{0, 1, 0}, -1.0f}};
         }},
        {"radius of 0 or more of tube light 0",
         [](ReferenceOptions& o) {
             o.extraLights.tubes = {{{0, 1, 0}, {0, NAN, 0}}};
         }},
        {"finite vertices in polygon light 0",
         [](ReferenceOptions& o) { o.extraLights.polygons[0].contours[0][2].x = INFINITY; }},
    };
    for (const BadOption& bad : cases) {
        ReferenceOptions options = makeNoisyOptions(16);
        bad.apply(options);
        EXPECT_THAT(test::errorOf([&] { ReferenceTracer tracer(scene, kCamera, options); }),
                    HasSubstr(bad.expected));
    }
    EXPECT_EQ(test::errorOf([&] { ReferenceTracer tracer(scene, kCamera, makeNoisyOptions(16)); }),
              "no error");
}

}  // namespace
}  // namespace polylume::reference
