// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/burley_diffuse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(BurleyDiffuse, albedoAtTheNormalViewHasItsClosedForm) {
    // The view's factor is 1; the integrals of 2 c (1 - c)^5 and 2 c^2 (1 - c)^5 are 1/21 and 1/84.
    const BurleyDiffuse brdf;
    for (const double roughness : {0.0, 0.3, 0.5, 1.0}) {
        EXPECT_NEAR(brdf.reflectance(roughness, 1.0).albedo,
                    1.0 + (roughness - 0.5) / 21.0 + roughness / 84.0, 1e-12);
    }
}

TEST(BurleyDiffuse, isLambertsWhereTheGrazingReflectanceIsOne) {
    // F = 0.5 + 2 r cos^2(theta_d) = 1 for r = 1/2 and directions at right angles.
    const BurleyDiffuse brdf;
    EXPECT_NEAR(brdf.evaluate({0.8, 0.0, 0.6}, {-0.6, 0.0, 0.8}, 0.5), 0.8 / kPi, 1e-15);
    // Back along the view theta_d is 0: F = 0.5 + 2 r.
    const double factor = 1.0 + 1.5 * std::pow(0.4, 5);
    EXPECT_NEAR(brdf.evaluate({0.8, 0.0, 0.6}, {0.8, 0.0, 0.6}, 1.0), factor * factor * 0.6 / kPi,
                1e-12);
}

TEST(BurleyDiffuse, theExcessOfItsAlbedoIsTheDocumentedOne) {
    const BurleyDiffuse brdf;
    double largest = 0.0;
    double smallest = 1.0;
    for (int i = 0; i <= 20; ++i) {
        for (int j = 0; j <= 20; ++j) {
            const double albedo = brdf.reflectance(i / 20.0, j / 20.0).albedo;
            largest = std::max(largest, albedo);
            smallest = std::min(smallest, albedo);
        }
    }
    EXPECT_LE(largest, BurleyDiffuse::kLargestAlbedo);
    EXPECT_GT(largest, BurleyDiffuse::kLargestAlbedo - 1e-3);
    EXPECT_NEAR(smallest, 0.49, 0.005);
}

}  // namespace
}  // namespace polylume::brdf
