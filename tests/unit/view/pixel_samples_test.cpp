// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "view/pixel_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace polylume {
namespace {

TEST(PixelSamplesTest, aSingleOneIsTheCentre) {
    ASSERT_EQ(pixelSamples(1).size(), 1u);
    EXPECT_EQ(pixelSamples(1).front(), glm::dvec2(0.5, 0.5));
}

TEST(PixelSamplesTest, meanIsTheCentre) {
    for (int count = 1; count <= 300; ++count) {
        glm::dvec2 sum(0.0);
        for (const glm::dvec2& sample : pixelSamples(count)) sum += sample;
        EXPECT_NEAR(sum.x / count, 0.5, 1e-12) << count;
        EXPECT_NEAR(sum.y / count, 0.5, 1e-12) << count;
    }
}

TEST(PixelSamplesTest, liesInItsPixel) {
    for (int count = 1; count <= 300; ++count) {
        for (const glm::dvec2& sample : pixelSamples(count)) {
            EXPECT_GE(std::min(sample.x, sample.y), 0.0) << count;
            EXPECT_LE(std::max(sample.x, sample.y), 1.0) << count;
        }
    }
}

TEST(PixelSamplesTest, everyRowAndColumnHoldsOne) {
    for (int count = 1; count <= 300; ++count) {
        std::set<int> columns, rows;
        for (const glm::dvec2& sample : pixelSamples(count)) {
            columns.insert(static_cast<int>(std::floor(sample.x * count)));
            rows.insert(static_cast<int>(std::floor(sample.y * count)));
        }
        EXPECT_EQ(columns.size(), static_cast<std::size_t>(count)) << count;
        EXPECT_EQ(rows.size(), static_cast<std::size_t>(count)) << count;
        EXPECT_EQ(*rows.begin(), 0);
        EXPECT_EQ(*rows.rbegin(), count - 1);
    }
}

TEST(PixelSamplesTest, fourAreTheRotatedGrid) {
    const std::vector<glm::dvec2> samples = pixelSamples(4);
    const std::vector<glm::dvec2> expected = {
        {0.125, 0.125}, {0.375, 0.625}, {0.625, 0.375}, {0.875, 0.875}};
    EXPECT_EQ(samples, expected);
}

}  // namespace
}  // namespace polylume
