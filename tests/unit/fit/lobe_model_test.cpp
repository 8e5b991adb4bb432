// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_model.hpp"

#include <gtest/gtest.h>

#include <array>

#include "brdf/ggx.hpp"

namespace polylume::fit {
namespace {

const ltc::LobeCode kCode{0.8, -0.1, -0.3, 0.7};
const ltc::LobeAxis kAxis{0.6, 0.8};
const glm::dvec3 kDirection = glm::normalize(glm::dvec3(-0.5, 0.2, 0.6));

constexpr std::array kMatrixMembers = {&ltc::Lobe::m11, &ltc::Lobe::m13, &ltc::Lobe::m31,
                                       &ltc::Lobe::m33};
constexpr std::array kCodeMembers = {&ltc::LobeCode::stretch, &ltc::LobeCode::tilt,
                                     &ltc::LobeCode::shear, &ltc::LobeCode::rootWidth};

constexpr double kStep = 1e-6;
constexpr double kTolerance = 1e-8;  // Of central differences with that step.

TEST(LobeModel, lobeIsTheDensityOverItsUpperShare) {
    const ltc::Lobe lobe = ltc::decode(kCode, kAxis);
    EXPECT_NEAR(normalisedLobe(kDirection, lobe, nullptr),
                ltc::lobeDensity(kDirection, lobe) / ltc::upperShare(lobe), 1e-13);
    EXPECT_LT(ltc::upperShare(lobe), 0.99);  // Else this test would see nothing.
}

TEST(LobeModel, derivativesByTheMatrixAreThoseOfFiniteDifferences) {
    const ltc::Lobe lobe = ltc::decode(kCode, kAxis);
    Eigen::Vector4d derivatives;
    normalisedLobe(kDirection, lobe, &derivatives);
    for (int i = 0; i < 4; ++i) {
        ltc::Lobe above = lobe;
        ltc::Lobe below = lobe;
        above.*kMatrixMembers[i] += kStep;
        below.*kMatrixMembers[i] -= kStep;
        EXPECT_NEAR((normalisedLobe(kDirection, above, nullptr) -
                     normalisedLobe(kDirection, below, nullptr)) /
                        (2.0 * kStep),
                    derivatives[i], kTolerance);
    }
}

TEST(LobeModel, derivativesByTheCodeAreThoseOfFiniteDifferences) {
    const Eigen::Matrix4d derivatives = codeDerivatives(kCode, kAxis);
    for (int i = 0; i < 4; ++i) {
        ltc::LobeCode above = kCode;
        ltc::LobeCode below = kCode;
        above.*kCodeMembers[i] += kStep;
        below.*kCodeMembers[i] -= kStep;
        const ltc::Lobe aboveLobe = ltc::decode(above, kAxis);
        const ltc::Lobe belowLobe = ltc::decode(below, kAxis);
        for (int j = 0; j < 4; ++j) {
            const double difference = aboveLobe.*kMatrixMembers[j] - belowLobe.*kMatrixMembers[j];
            EXPECT_NEAR(difference / (2.0 * kStep), derivatives(j, i), kTolerance);
        }
    }
}

ltc::TableEntry entryOf(const ltc::LobeCode& code) {
    ltc::TableEntry entry;
    entry.lobes[0] = ltc::decode(code, kAxis);
    return entry;
}

TEST(LobeModel, errorOfTheSameLobeIsZeroAndOfOneFarAwayNearlyTwo) {
    LobeSamples samples = sampleLobe(brdf::Ggx(), 1.0, 0.5, 96);
    for (LobeSamples::Point& point : samples.points) {
        point.target = modelDensity(point.direction, entryOf(kCode));
    }
    EXPECT_NEAR(lobeError(samples, entryOf(kCode)), 0.0, 1e-12);
    // On the other side of the normal: what overlaps is the two tails.
    const double away = lobeError(samples, entryOf({1.0, -3.0, 0.0, 0.5}));
    EXPECT_GT(away, 1.7);
    EXPECT_LE(away, 2.0);
}

TEST(LobeModel, twoLobesAddUpByTheirShares) {
    ltc::TableEntry entry = entryOf(kCode);
    entry.lobeCount = 2;
    entry.lobes[1] = ltc::Lobe{};
    entry.shares = {0.3, 0.7};
    EXPECT_NEAR(modelDensity(kDirection, entry),
                0.3 * normalisedLobe(kDirection, entry.lobes[0], nullptr) +
                    0.7 * normalisedLobe(kDirection, entry.lobes[1], nullptr),
                1e-15);
}

}  // namespace
}  // namespace polylume::fit
