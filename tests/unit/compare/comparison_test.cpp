// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pictures.hpp"
#include "polylume/error.hpp"

namespace polylume::compare {
namespace {

using test::makePicture;

Comparison compare(const NamedPicture& test, const NamedPicture& reference) {
    Progress progress;
    return comparePictures(PicturePair(test, reference, {}), 67.0, progress);
}

/// A grey picture of 2x2 pixels.
NamedPicture makeGrey(const std::vector<float>& values) {
    NamedPicture picture = makePicture("a.exr", 2, 2, {"Y"});
    picture.image.pixels = values;
    return picture;
}

bool passes(const Comparison& comparison, const Limits& limits) {
    bool passed = true;
    for (const Verdict& verdict : checkLimits(comparison, limits)) passed &= verdict.passed;
    return passed;
}

TEST(Comparison, measuresByHand) {
    // Differences 1, -3, 0 and 4, of a mean of 5.
    const Comparison comparison = compare(makeGrey({3, 1, 6, 12}), makeGrey({2, 4, 6, 8}));
    const LayerDifference& layer = comparison.layers.at(0);
    EXPECT_NEAR(layer.rmse, std::sqrt(26.0 / 4.0), 1e-15);
    EXPECT_NEAR(layer.relativeRmse, std::sqrt(26.0 / 4.0) / 5.0, 1e-15);
    EXPECT_NEAR(layer.bias, 0.5, 1e-15);
    EXPECT_NEAR(layer.relativeBias, 0.1, 1e-15);
    EXPECT_NEAR(layer.meanAbsolute, 2.0, 1e-15);
    EXPECT_NEAR(layer.relativeMeanAbsolute, 0.4, 1e-15);
    EXPECT_EQ(layer.maximum, 4.0);
    EXPECT_EQ(layer.maximumAt.x, 1);
    EXPECT_EQ(layer.maximumAt.y, 1);
    EXPECT_EQ(layer.maximumAt.channel, "Y");
    EXPECT_EQ(layer.maximumAt.test, 12.0);
    EXPECT_EQ(layer.maximumAt.reference, 8.0);
    EXPECT_NEAR(layer.psnr, 10.0 * std::log10(64.0 / 6.5), 1e-12);
}

TEST(Comparison, displayValuesHaveAPeakOfOne) {
    NamedPicture a = makeGrey({0.5f, 0.5f, 0.5f, 0.5f});
    NamedPicture b = makeGrey({0.25f, 0.25f, 0.25f, 0.25f});
    a.image.values = b.image.values = PixelValues::display;
    const Comparison comparison = compare(a, b);
    EXPECT_NEAR(comparison.layers[0].psnr, 20.0 * std::log10(4.0), 1e-12);
    EXPECT_FALSE(comparison.exposures.has_value());
    EXPECT_TRUE(compare(makeGrey({1, 1, 1, 1}), makeGrey({1, 1, 1, 2})).exposures.has_value());
}

TEST(Comparison, sumsInDoublePrecision) {
    // In single precision the squares of 3e38 overflow and 1e-3 drowns in 1e8.
    const Comparison large = compare(makeGrey({3e38f, 0, 0, 0}), makeGrey({-3e38f, 0, 0, 0}));
    EXPECT_NEAR(large.layers[0].rmse / 3e38, 1.0, 1e-6);
    EXPECT_NEAR(large.layers[0].maximum / 6e38, 1.0, 1e-6);
    const Comparison small = compare(makeGrey({1e8f, 0.001f, 0, 0}), makeGrey({1e8f, 0, 0, 0}));
    EXPECT_NEAR(small.layers[0].bias / 2.5e-4, 1.0, 1e-6);
}

TEST(Comparison, theMagnitudeOfSignedLayersCounts) {
    // The mean of B is 0.
    const Comparison comparison = compare(makeGrey({1.5f, -1, 1, -1}), makeGrey({1, -1, 1, -1}));
    EXPECT_NEAR(comparison.layers[0].relativeRmse, 0.25, 1e-12);
}

TEST(Comparison, equalPicturesAreWithinAllLimits) {
    const NamedPicture a = makeGrey({1, 2, 3, 4});
    const Comparison comparison = compare(a, a);
    EXPECT_EQ(comparison.layers[0].rmse, 0.0);
    EXPECT_EQ(comparison.layers[0].maximumAt.test, 1.0);
    EXPECT_TRUE(std::isinf(comparison.layers[0].psnr));
    EXPECT_TRUE(passes(comparison, {0.0, 0.0, 0.0}));
}

TEST(Comparison, aBlackReferenceIsInfinitelyWrong) {
    const NamedPicture black = makeGrey({0, 0, 0, 0});
    const Comparison comparison = compare(makeGrey({0, 0, 0, 1e-3f}), black);
    EXPECT_TRUE(std::isinf(comparison.layers[0].relativeRmse));
    EXPECT_FALSE(passes(comparison, {1e300, {}, {}}));
    EXPECT_TRUE(passes(comparison, {{}, 0.002, {}}));
    EXPECT_TRUE(passes(compare(black, black), {0.0, 0.0, 0.0}));
}

TEST(Comparison, eachLimitCanFail) {
    const Comparison comparison = compare(makeGrey({3, 1, 6, 12}), makeGrey({2, 4, 6, 8}));
    const double relativeRmse = comparison.layers[0].relativeRmse;
    const double flip = comparison.flip.value().mean;
    ASSERT_GT(flip, 0.01);
    EXPECT_TRUE(passes(comparison, {relativeRmse, 4.0, flip}));
    EXPECT_FALSE(passes(comparison, {0.999 * relativeRmse, 4.0, flip}));
    EXPECT_FALSE(passes(comparison, {relativeRmse, 3.999, flip}));
    EXPECT_FALSE(passes(comparison, {relativeRmse, 4.0, 0.999 * flip}));
    EXPECT_TRUE(passes(comparison, {}));
}

TEST(Comparison, limitsHoldForEveryLayer) {
    NamedPicture a = makePicture("a.exr", 3, 3, {"R", "G", "B", "A", "normal.X", "normal.Z"});
    const NamedPicture b = a;
    a.image.pixel(2, 1)[4] = -0.5f;
    const Comparison comparison = compare(a, b);
    ASSERT_EQ(comparison.layers.size(), 3u);
    EXPECT_EQ(comparison.layers[0].maximum, 0.0);
    EXPECT_EQ(comparison.layers[2].maximum, 1.0);
    EXPECT_EQ(comparison.layers[2].maximumAt.channel, "normal.X");
    const std::vector<Verdict> verdicts = checkLimits(comparison, {0.01, 0.9, 0.0});
    ASSERT_EQ(verdicts.size(), 7u);  // Two for each layer, one for the colours.
    for (const Verdict& verdict : verdicts) EXPECT_EQ(verdict.passed, verdict.layer != "normal");
}

TEST(Comparison, flipNeedsColors) {
    const NamedPicture a = makePicture("a.exr", 2, 2, {"normal.X", "normal.Y", "normal.Z"});
    const Comparison comparison = compare(a, a);
    EXPECT_FALSE(comparison.flip.has_value());
    EXPECT_TRUE(passes(comparison, {0.0, 0.0, {}}));
    EXPECT_THROW(checkLimits(comparison, {{}, {}, 0.5}), Error);
}

}  // namespace
}  // namespace polylume::compare
