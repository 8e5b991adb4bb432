// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "figures/picture_maker.hpp"
#include "scene/gltf_reader.hpp"

// How far pictures by linearly transformed cosines are from ray-traced ones. The errors below are
// those that the README states; a change that makes one of them larger by more than a tenth fails.
namespace polylume {
namespace {

using figures::ErrorMeasures;
using figures::PictureMaker;

/// Mean |difference| over the mean of the truth.
struct KnownErrors {
    double oneLobe, twoLobes;
};

void PrintTo(const KnownErrors& errors, std::ostream* stream) {
    *stream << errors.oneLobe << ", " << errors.twoLobes;
}

constexpr double kAllowedGrowth = 1.1;

PictureMaker makePictureMaker() {
    // The truth's noise is below a tenth of every error here.
    return PictureMaker(Backend::automatic, {{160, 90}, 4, 4096, 0.003, 1});
}

void expectErrors(const KnownErrors& known, const ErrorMeasures& one, const ErrorMeasures& two) {
    EXPECT_LT(one.meanAbsolute, kAllowedGrowth * known.oneLobe);
    EXPECT_LT(two.meanAbsolute, kAllowedGrowth * known.twoLobes);
}

class SceneErrorTest : public ::testing::TestWithParam<std::pair<std::string, KnownErrors>> {};

TEST_P(SceneErrorTest, areNotLargerThanStated) {
    const auto& [name, known] = GetParam();
    Progress progress;
    const scene::Scene scene =
        scene::readGltf(POLYLUME_SOURCE_DIR "/samples/scenes/" + name + ".glb", progress);
    PictureMaker maker = makePictureMaker();
    const FloatImage truth = maker.trace(scene, 1, progress).image;
    expectErrors(
        known, figures::measureErrors(maker.drawLtc(scene, Quality::standard, false).image, truth),
        figures::measureErrors(maker.drawLtc(scene, Quality::high, false).image, truth));
}

INSTANTIATE_TEST_SUITE_P(
    Samples, SceneErrorTest,
    ::testing::Values(std::pair(std::string("cornell"), KnownErrors{0.0089, 0.0076}),
                      std::pair(std::string("gallery"), KnownErrors{0.0180, 0.0182}),
                      std::pair(std::string("studio"), KnownErrors{0.0108, 0.0132})),
    [](const auto& test) { return test.param.first; });

class FloorErrorTest : public ::testing::TestWithParam<std::pair<int, KnownErrors>> {};

TEST_P(FloorErrorTest, areNotLargerThanStated) {
    const auto& [percent, known] = GetParam();
    PictureMaker maker = makePictureMaker();
    const double roughness = 0.01 * percent;
    expectErrors(known, measureFloor(maker, roughness, Quality::standard),
                 measureFloor(maker, roughness, Quality::high));
}

INSTANTIATE_TEST_SUITE_P(Roughness, FloorErrorTest,
                         ::testing::Values(std::pair(35, KnownErrors{0.0406, 0.0151}),
                                           std::pair(50, KnownErrors{0.0648, 0.0152}),
                                           std::pair(75, KnownErrors{0.1006, 0.0123}),
                                           std::pair(100, KnownErrors{0.0616, 0.0114})),
                         [](const auto& test) { return std::to_string(test.param.first); });

}  // namespace
}  // namespace polylume
