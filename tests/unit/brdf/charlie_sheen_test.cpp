// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/charlie_sheen.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/brdf/brdf_checks.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(CharlieSheen, distributionOfNormalsFillsTheSurface) {
    for (const double alpha : {0.01, 0.2, 1.0}) {
        const double area = sphereIntegral({0.0, 0.0, 1.0}, 1.0, [&](const glm::dvec3& h) {
            return h.z > 0.0 ? charlieDistribution(h, alpha) * h.z : 0.0;
        });
        EXPECT_NEAR(area, 1.0, 1e-9) << alpha;
    }
}

TEST(CharlieSheen, lambdaHasItsPublishedForm) {
    // Worked out from the constants apart from this program.
    EXPECT_NEAR(charlieLambda(0.25, 1.0), 2.0065177434, 1e-9);
    EXPECT_NEAR(charlieLambda(0.25, 0.25), 3.5971044319, 1e-9);
    EXPECT_NEAR(charlieLambda(0.75, 0.25), 0.5285251283, 1e-9);
    for (const double alpha : {0.01, 0.3, 1.0}) {
        // One form passes into the other with the same value and slope.
        const double left = charlieLambda(0.5 - 1e-7, alpha);
        const double middle = charlieLambda(0.5, alpha);
        const double right = charlieLambda(0.5 + 1e-7, alpha);
        EXPECT_NEAR(middle - left, right - middle, 1e-9 * middle);
    }
}

TEST(CharlieSheen, evaluatesTheProductOfItsParts) {
    const CharlieSheen sheen;
    // View and light 90 degrees apart, both at 45 degrees: h is the normal, where D is 0.
    const double diagonal = std::sqrt(0.5);
    EXPECT_NEAR(sheen.evaluate({diagonal, 0.0, diagonal}, {-diagonal, 0.0, diagonal}, 1.0), 0.0,
                1e-12);
    // Light back along the view at 60 degrees and alpha = 1: D = 3 sin / (2 pi).
    const glm::dvec3 view = viewDirection(0.5);
    const double expected =
        3.0 * view.x / (2.0 * kPi) / (4.0 * 0.5 * (1.0 + 2.0 * charlieLambda(0.5, 1.0)));
    EXPECT_NEAR(sheen.evaluate(view, view, 1.0), expected, 1e-12);
}

TEST(CharlieSheen, theFloorOfAlphaKeepsItsAlbedoBelowOne) {
    const CharlieSheen sheen;
    double largest = 0.0;
    for (const double roughness : {0.0, 0.27, 0.4, 0.7, 1.0}) {
        for (int i = 1; i <= 60; ++i) {
            largest = std::max(largest, sheen.reflectance(roughness, i * i / 36000.0).albedo);
        }
    }
    EXPECT_LE(largest, 1.0);
    // Not for nothing: it is nearly reached, 0.26 degrees above the surface at the floor.
    EXPECT_GT(largest, 0.98);
}

}  // namespace
}  // namespace polylume::brdf
