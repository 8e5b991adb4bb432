// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "compare/plane_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace polylume::compare {
namespace {

Plane makePlane(int width, int height, const std::function<float(int, int)>& value) {
    Plane plane(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) plane.row(y)[x] = value(x, y);
    }
    return plane;
}

TEST(PlaneFilter, weightsSumToOne) {
    const Kernel smooth = gaussianKernel(2.0, 6);
    EXPECT_NEAR(
        smooth.center + 2.0f * std::accumulate(smooth.sides.begin(), smooth.sides.end(), 0.0f),
        1.0f, 1e-6f);
    EXPECT_NEAR(smooth.sides[1] / smooth.center, std::exp(-0.5f), 1e-6f);
    const Kernel slope = slopeKernel(2.0, 6);
    EXPECT_NEAR(std::accumulate(slope.sides.begin(), slope.sides.end(), 0.0f), 1.0f, 1e-6f);
    const Kernel curvature = curvatureKernel(2.0, 6);
    float positive = 0.0f;
    for (const float weight : curvature.sides) positive += std::max(weight, 0.0f);
    EXPECT_NEAR(2.0f * positive, 1.0f, 1e-6f);
    EXPECT_EQ(curvature.sides[1], 0.0f);  // One standard deviation from the middle.
}

TEST(PlaneFilter, constantsStayAndHaveNoSlopeOrCurvature) {
    const Plane flat = makePlane(5, 4, [](int, int) { return 0.3f; });
    for (const float value : filterColumns(flat, gaussianKernel(3.0, 9)).values) {
        EXPECT_NEAR(value, 0.3f, 1e-6f);
    }
    for (const Kernel& kernel : {slopeKernel(3.0, 9), curvatureKernel(3.0, 9)}) {
        for (const float value : filterRows(flat, kernel).values) EXPECT_EQ(value, 0.0f);
        for (const float value : filterColumns(flat, kernel).values) EXPECT_EQ(value, 0.0f);
    }
}

TEST(PlaneFilter, anImpulseShowsTheKernel) {
    const Kernel kernel = slopeKernel(1.0, 3);
    const Plane impulse = makePlane(11, 9, [](int x, int y) { return x == 5 && y == 4; });
    const Plane rows = filterRows(impulse, kernel);
    const Plane columns = filterColumns(impulse, kernel);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 11; ++x) {
            const auto weightAt = [&](int distance) {
                if (distance == 0 || std::abs(distance) > 3) return 0.0f;
                const float weight = kernel.sides[static_cast<std::size_t>(std::abs(distance)) - 1];
                return distance > 0 ? weight : -weight;
            };
            EXPECT_EQ(rows.row(y)[x], y == 4 ? weightAt(5 - x) : 0.0f) << x << ", " << y;
            EXPECT_EQ(columns.row(y)[x], x == 5 ? weightAt(4 - y) : 0.0f) << x << ", " << y;
        }
    }
}

TEST(PlaneFilter, theBorderGoesOn) {
    // A ramp's slope is that of the ramp inside, and less where the border's values repeat.
    const Plane ramp = makePlane(30, 1, [](int x, int) { return static_cast<float>(x); });
    const Plane slopes = filterRows(ramp, slopeKernel(2.0, 6));
    double expected = 0.0;
    double weightSum = 0.0;
    for (int x = 1; x <= 6; ++x) {
        expected += 2.0 * x * x * std::exp(-x * x / 8.0);
        weightSum += x * std::exp(-x * x / 8.0);
    }
    EXPECT_NEAR(slopes.values[15], expected / weightSum, 1e-4);
    EXPECT_NEAR(slopes.values[0], 0.5 * expected / weightSum, 1e-4);
    EXPECT_NEAR(slopes.values[29], 0.5 * expected / weightSum, 1e-4);
    // Shorter than the filter.
    EXPECT_EQ(filterRows(makePlane(1, 3, [](int, int y) { return y * 1.0f; }), slopeKernel(2.0, 6))
                  .values,
              std::vector<float>(3, 0.0f));
}

}  // namespace
}  // namespace polylume::compare
