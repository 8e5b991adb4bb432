// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/oren_nayar.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(OrenNayar, isLambertsAtNoRoughness) {
    const OrenNayar brdf;
    for (const double cosTheta : {1.0, 0.5, 0.01}) {
        const glm::dvec3 view = viewDirection(cosTheta);
        EXPECT_NEAR(brdf.evaluate(view, {0.6, 0.0, 0.8}, 0.0), 0.8 / kPi, 1e-15);
        EXPECT_NEAR(brdf.evaluate(view, {0.0, -0.8, 0.6}, 0.0), 0.6 / kPi, 1e-15);
        EXPECT_NEAR(brdf.reflectance(0.0, cosTheta).albedo, 1.0, 1e-15);
    }
}

TEST(OrenNayar, followsTheQualitativeModel) {
    const OrenNayar brdf;
    const double even = 1.0 - 0.5 * 0.25 / 0.58;
    const double retrograde = 0.45 * 0.25 / 0.34;
    const glm::dvec3 view = viewDirection(0.5);
    // Back along the view, at 60 degrees: sin tan = 1.5.
    EXPECT_NEAR(brdf.evaluate(view, view, 0.5), (even + 1.5 * retrograde) * 0.5 / kPi, 1e-12);
    // Light at 30 degrees, 45 degrees off the view's azimuth: the larger angle has the sine.
    const double diagonal = std::sqrt(0.5);
    const glm::dvec3 light(0.5 * diagonal, 0.5 * diagonal, std::sqrt(0.75));
    const double geometry = diagonal * std::sqrt(0.75) * std::tan(kPi / 6.0);
    EXPECT_NEAR(brdf.evaluate(view, light, 0.5),
                (even + retrograde * geometry) * std::sqrt(0.75) / kPi, 1e-12);
    // Away from the view only the even part is left.
    EXPECT_NEAR(brdf.evaluate(view, {-view.x, 0.0, view.z}, 0.5), even * 0.5 / kPi, 1e-15);
}

TEST(OrenNayar, theExcessOfItsAlbedoIsTheDocumentedOne) {
    const OrenNayar brdf;
    double largest = 0.0;
    for (int i = 0; i <= 100; ++i) {
        for (const double cosTheta : {1e-4, 0.001, 0.01, 0.1, 0.3}) {
            largest = std::max(largest, brdf.reflectance(i / 100.0, cosTheta).albedo);
        }
    }
    EXPECT_LE(largest, OrenNayar::kLargestAlbedo);
    EXPECT_GT(largest, OrenNayar::kLargestAlbedo - 5e-4);
}

}  // namespace
}  // namespace polylume::brdf
