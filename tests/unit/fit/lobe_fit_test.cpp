// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/ggx.hpp"

namespace polylume::fit {
namespace {

/// Samples of a lobe that the fit can match exactly.
LobeSamples samplesOf(const LobeShape& shape) {
    LobeSamples samples = sampleLobe(brdf::Ggx(), 0.7, 0.6, 48);
    double sum = 0.0;
    for (LobeSamples::Point& point : samples.points) {
        const double lobe = normalisedLobe(point.direction, matrixOf(shape), nullptr);
        point.weight *= lobe / point.target;
        point.target = lobe;
        sum += point.weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-4);
    std::erase_if(samples.points, [](const auto& point) { return !(point.target > 0.0); });
    return samples;
}

TEST(LobeFit, recoversALobeFromItsMoments) {
    const LobeShape truth{0.5, -0.2, -0.9, 0.3};
    const LobeSamples samples = samplesOf(truth);
    const LobeShape found = fitLobe(samples, fitLobe(samples, momentShape(samples), 0.3), 0.02);
    EXPECT_NEAR(found.tilt, truth.tilt, 1e-6);
    EXPECT_NEAR(found.logStretch, truth.logStretch, 1e-6);
    EXPECT_NEAR(found.logWidth, truth.logWidth, 1e-6);
    EXPECT_NEAR(found.shear, truth.shear, 1e-6);
}

TEST(LobeFit, roundLobesStayRound) {
    const LobeSamples samples = sampleLobe(brdf::Ggx(), 0.6, 1.0, 32);
    const LobeShape found =
        fitLobe(samples, LobeShape{0.3, 0.2, -0.5, 0.1}, 0.02, LobeFreedom::round);
    EXPECT_EQ(found.tilt, 0.0);
    EXPECT_EQ(found.logStretch, 0.0);
    EXPECT_EQ(found.shear, 0.0);
    // The normal view of GGX is near a clamped cosine of width 2 alpha / (1 + alpha).
    EXPECT_LT(lobeError(samples, matrixOf(found)), 0.05);
}

TEST(LobeFit, endsWhereNoSmallMoveHelps) {
    const LobeSamples samples = sampleLobe(brdf::Ggx(), 0.5, 0.4, 32);
    const LobeShape found = fitLobe(samples, fitLobe(samples, momentShape(samples), 0.3), 0.02);
    const double error = evaluateObjective(samples, matrixOf(found), 0.02).value;
    for (const double step : {-1e-3, 1e-3}) {
        for (LobeShape moved : {LobeShape{step, 0, 0, 0}, LobeShape{0, step, 0, 0},
                                LobeShape{0, 0, step, 0}, LobeShape{0, 0, 0, step}}) {
            moved.tilt += found.tilt;
            moved.logStretch += found.logStretch;
            moved.logWidth += found.logWidth;
            moved.shear += found.shear;
            EXPECT_GT(evaluateObjective(samples, matrixOf(moved), 0.02).value, error);
        }
    }
}

}  // namespace
}  // namespace polylume::fit
