// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/sphere_form_factor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polylume::tables {
namespace {

constexpr double kPi = std::numbers::pi;

/// Integral of max(cos, 0) / pi over the cap of directions, by the midpoint rule.
double quadrature(double cosine, double sine) {
    constexpr int kCount = 1000;
    const double halfAngle = std::asin(sine);
    const double sineAngle = std::sqrt(1.0 - cosine * cosine);
    double sum = 0.0;
    for (int i = 0; i < kCount; ++i) {
        const double theta = (i + 0.5) / kCount * halfAngle;
        for (int j = 0; j < kCount; ++j) {
            const double phi = (j + 0.5) / kCount * 2.0 * kPi;
            const double z = std::cos(theta) * cosine + std::sin(theta) * std::cos(phi) * sineAngle;
            sum += std::max(z, 0.0) * std::sin(theta);
        }
    }
    return sum * 2.0 * halfAngle / kCount / kCount;
}

TEST(SphereFormFactor, agreesWithQuadrature) {
    for (const double sine : {0.2, 0.5, 0.9, 0.99}) {
        for (const double cosine : {-0.95, -0.6, -0.15, 0.0, 0.1, 0.3, 0.55, 0.95}) {
            // The midpoint rule's error at the kink along the horizon.
            EXPECT_NEAR(sphereFormFactor(cosine, sine), quadrature(cosine, sine), 2e-6)
                << cosine << " " << sine;
        }
    }
}

TEST(SphereFormFactor, closedFormsAtTheEnds) {
    EXPECT_DOUBLE_EQ(sphereFormFactor(0.8, 0.5), 0.8 * 0.25);  // Wholly above.
    EXPECT_EQ(sphereFormFactor(-0.8, 0.5), 0.0);               // Wholly below.
    // A sphere that touches the point fills a hemisphere: half of one about the normal of a tilted
    // plane is (1 + cos) / 2.
    for (const double cosine : {-1.0, -0.5, 0.0, 0.7, 1.0}) {
        EXPECT_NEAR(sphereFormFactor(cosine, 1.0), 0.5 * (1.0 + cosine), 1e-12) << cosine;
    }
}

TEST(SphereFormFactor, isContinuousWhereItsCasesMeet) {
    constexpr double kStep = 1e-9;
    for (const double sine : {0.1, 0.5, 0.9}) {
        for (const double cosine : {-sine, 0.0, sine}) {
            EXPECT_NEAR(sphereFormFactor(cosine - kStep, sine),
                        sphereFormFactor(cosine + kStep, sine), 1e-8);
        }
    }
}

TEST(SphereFormFactor, ratioIsTheShareThatTheHorizonLeaves) {
    EXPECT_DOUBLE_EQ(sphereHorizonRatio(0.9, 0.04), 0.9);
    EXPECT_DOUBLE_EQ(sphereHorizonRatio(0.4, 0.0), 0.4);
    EXPECT_EQ(sphereHorizonRatio(-0.4, 0.0), 0.0);
    EXPECT_NEAR(sphereHorizonRatio(0.2, 0.5) * 0.5, sphereFormFactor(0.2, std::sqrt(0.5)), 1e-15);
    for (int i = 0; i <= 63; ++i) {
        for (int j = 0; j <= 63; ++j) {
            const double ratio = sphereHorizonRatio(2.0 * i / 63 - 1.0, j / 63.0);
            ASSERT_TRUE(ratio >= 0.0 && ratio <= 1.0 + 1e-12) << i << " " << j << " " << ratio;
        }
    }
}

}  // namespace
}  // namespace polylume::tables
