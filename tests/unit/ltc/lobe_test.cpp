// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "ltc/lobe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace polylume::ltc {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(LobeCode, decodeAndEncodeAreEachOthersInverse) {
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const LobeCode code{std::exp(2.0 * uniform(generator)), 3.0 * uniform(generator),
                            2.0 * uniform(generator), std::exp(3.0 * uniform(generator))};
        const double angle = 0.5 * kPi * uniform(generator);
        const LobeAxis axis{std::sin(angle), std::cos(angle)};
        const Lobe lobe = decode(code, axis);
        // The determinant is width stretch^2, so every code is a lobe.
        const double width = code.rootWidth * code.rootWidth;
        EXPECT_NEAR(
            (lobe.m11 * lobe.m33 - lobe.m13 * lobe.m31) / (width * code.stretch * code.stretch),
            1.0, 1e-9);
        const LobeCode again = encode(lobe, axis);
        EXPECT_NEAR(again.stretch / code.stretch, 1.0, 1e-9);
        EXPECT_NEAR(again.tilt, code.tilt, 1e-9);
        EXPECT_NEAR(again.shear, code.shear, 1e-7 * (1.0 + 1.0 / width));
        EXPECT_NEAR(again.rootWidth / code.rootWidth, 1.0, 1e-9);
    }
}

TEST(LobeCode, withoutTiltTheLobePointsAlongTheAxis) {
    const LobeAxis axis{0.6, 0.8};
    for (const double shear : {0.0, 0.7}) {
        const Lobe lobe = decode({0.5, 0.0, shear, 0.3}, axis);
        // M^-1 brings the axis (-sine, 0, cosine) to z.
        EXPECT_NEAR(-lobe.m11 * axis.sine + lobe.m13 * axis.cosine, 0.0, 1e-15);
        EXPECT_GT(-lobe.m31 * axis.sine + lobe.m33 * axis.cosine, 0.0);
    }
    // A tilt of tan 10 degrees leans 10 degrees further from the normal.
    const Lobe leaning = decode({0.5, std::tan(kPi / 18.0), 0.0, 0.3}, axis);
    const double angle = std::atan2(axis.sine, axis.cosine) + kPi / 18.0;
    EXPECT_NEAR(-leaning.m11 * std::sin(angle) + leaning.m13 * std::cos(angle), 0.0, 1e-15);
}

TEST(LobeAxis, goesFromTheMirrorDirectionToTheNormal) {
    const double cosTheta = 0.3;
    const double sinTheta = std::sqrt(1.0 - cosTheta * cosTheta);
    const LobeAxis mirror = lobeAxis(LobeReference::mirror, 0.0, cosTheta);
    EXPECT_NEAR(mirror.sine, sinTheta, 1e-15);
    EXPECT_NEAR(mirror.cosine, cosTheta, 1e-15);
    const LobeAxis normal = lobeAxis(LobeReference::mirror, 1.0, cosTheta);
    EXPECT_EQ(normal.sine, 0.0);
    EXPECT_EQ(normal.cosine, 1.0);
    for (const double roughness : {0.0, 0.5, 1.0}) {
        const LobeAxis half = lobeAxis(LobeReference::bisector, roughness, cosTheta);
        EXPECT_NEAR(2.0 * half.sine * half.cosine, sinTheta, 1e-15);
    }
}

}  // namespace
}  // namespace polylume::ltc
