// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/moment_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/ggx.hpp"
#include "fit/lobe_model.hpp"

namespace polylume::fit {
namespace {

constexpr double kRoughness = 0.6;
constexpr double kCosThetaView = 0.7;

ltc::LobeAxis axisOf(const ltc::TableLayout& layout) {
    return ltc::lobeAxis(layout.reference, kRoughness, kCosThetaView);
}

LobeSamples samplesOf(const ltc::TableEntry& entry) {
    LobeSamples samples = sampleLobe(brdf::Ggx(), kRoughness, kCosThetaView, 64);
    for (LobeSamples::Point& point : samples.points) {
        point.target = modelDensity(point.direction, entry);
    }
    return samples;
}

TEST(MomentFit, isExactForALobe) {
    // The least squares have it as their only solution once the last row's direction is right;
    // three rounds bring that near.
    const ltc::TableLayout layout;
    ltc::TableNode truth;
    truth.codes[0] = {0.85, -0.1, 0.15, 0.6};
    const ltc::TableEntry entry = layout.decode(truth, kRoughness, kCosThetaView);
    const LobeSamples samples = samplesOf(entry);
    const ltc::TableNode found = momentNode(samples, layout, axisOf(layout));
    const double error = lobeError(samples, layout.decode(found, kRoughness, kCosThetaView));
    EXPECT_LT(error, 0.01);
    // Seen against the wrong lobe it would be far from 0.
    EXPECT_GT(lobeError(samples, ltc::TableEntry{}), 0.5);
}

TEST(MomentFit, twoLobesAreNearerThanOne) {
    ltc::TableLayout one;
    ltc::TableLayout two;
    two.lobeCount = 2;
    // About one axis, of equal shares: what the closed form can express.
    ltc::TableNode truth;
    truth.codes[0] = {0.9, 0.0, 0.1, 0.5};
    truth.codes[1] = {0.9, 0.0, 0.1, 0.9};
    truth.share2 = 0.5;
    const LobeSamples samples = samplesOf(two.decode(truth, kRoughness, kCosThetaView));
    const auto errorOf = [&](const ltc::TableLayout& layout) {
        const ltc::TableNode node = momentNode(samples, layout, axisOf(layout));
        return lobeError(samples, layout.decode(node, kRoughness, kCosThetaView));
    };
    EXPECT_LT(errorOf(two), 0.5 * errorOf(one));
}

TEST(MomentFit, givesALobeWithACodeWhereverTheSamplesPoint) {
    const ltc::TableLayout layout;
    LobeSamples samples = sampleLobe(brdf::Ggx(), kRoughness, kCosThetaView, 16);
    for (LobeSamples::Point& point : samples.points) {
        // All light back to the viewer, far from the mirror direction.
        point.target = std::pow(std::max(point.direction.x, 0.0), 8.0);
    }
    const ltc::LobeCode code = momentNode(samples, layout, axisOf(layout)).codes[0];
    EXPECT_GT(code.stretch, 0.0);
    EXPECT_GT(code.rootWidth, 0.0);
    EXPECT_TRUE(std::isfinite(code.tilt) && std::isfinite(code.shear));
}

}  // namespace
}  // namespace polylume::fit
