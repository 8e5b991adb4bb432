// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/modified_phong.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace polylume::brdf {
namespace {

TEST(ModifiedPhong, exponentFollowsTheRoughness) {
    EXPECT_EQ(phongExponent(1.0), 0.0);
    EXPECT_NEAR(phongExponent(0.5), 30.0, 1e-12);
    EXPECT_NEAR(phongExponent(0.0), 2e8 - 2.0, 1.0);
}

TEST(ModifiedPhong, reflectsEverythingAtNormalIncidence) {
    // (n + 2) / (2 pi) normalises cos^(n + 1).
    const ModifiedPhong phong;
    for (int i = 0; i <= 20; ++i) {
        EXPECT_NEAR(phong.reflectance(i / 20.0, 1.0).albedo, 1.0, 1e-7) << i;
    }
}

TEST(ModifiedPhong, albedoAtExponentZeroIsThatOfALune) {
    // 1 / pi over the hemisphere about the mirror direction: (1 + cos) / 2 of it lies above.
    const ModifiedPhong phong;
    for (const double cosTheta : {0.9, 0.5, 0.1, 0.001}) {
        EXPECT_NEAR(phong.reflectance(1.0, cosTheta).albedo, 0.5 * (1.0 + cosTheta), 1e-9);
    }
}

TEST(ModifiedPhong, narrowLobesMirror) {
    const ModifiedPhong phong;
    // Weighted by the light's cosine, which the lobe holds still.
    EXPECT_NEAR(phong.reflectance(0.0, 0.4).albedo, 0.4, 1e-6);
    EXPECT_NEAR(phong.reflectance(0.0, 0.4).fresnel, 0.4 * std::pow(0.6, 5), 1e-6);
    const glm::dvec3 view = viewDirection(0.4);
    const double peak = phong.evaluate(view, {-view.x, 0.0, view.z}, 0.0);
    EXPECT_NEAR(peak, 2e8 / (2.0 * std::numbers::pi) * 0.4, 1.0);
    // One alpha off its middle it has fallen to 1/e: 1 - cos(a) has kept its digits.
    const double angle = std::atan2(view.z, -view.x) + 1e-4;
    const double side = phong.evaluate(view, {std::cos(angle), 0.0, std::sin(angle)}, 0.0);
    EXPECT_NEAR(side / peak * view.z / std::sin(angle), std::exp(-1.0), 1e-6);
}

}  // namespace
}  // namespace polylume::brdf
