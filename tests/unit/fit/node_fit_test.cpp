// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/node_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/ggx.hpp"
#include "fit/lobe_model.hpp"
#include "fit/moment_fit.hpp"

namespace polylume::fit {
namespace {

const ltc::LobeAxis kAxis = ltc::lobeAxis(ltc::LobeReference::mirror, 0.7, 0.6);

ltc::TableEntry entryOf(const ltc::TableNode& node, int lobeCount) {
    ltc::TableLayout layout;
    layout.lobeCount = lobeCount;
    return layout.decode(node, 0.7, 0.6);
}

/// Samples that the lobes of `truth` match exactly.
LobeSamples samplesOf(const ltc::TableNode& truth, int lobeCount) {
    LobeSamples samples = sampleLobe(brdf::Ggx(), 0.7, 0.6, 48);
    for (LobeSamples::Point& point : samples.points) {
        point.target = modelDensity(point.direction, entryOf(truth, lobeCount));
    }
    return samples;
}

ltc::TableNode oneLobe() {
    ltc::TableNode node;
    node.codes[0] = {0.8, -0.25, 0.2, 0.7};
    return node;
}

ltc::TableNode twoLobes() {
    ltc::TableNode node = oneLobe();
    node.codes[1] = {0.7, -0.35, 0.1, 1.1};
    node.share2 = 0.4;
    return node;
}

FitTerm termOf(const LobeSamples& samples) {
    return {&samples, kAxis, 1.0, 1.0, zeroNode()};
}

NodeGoal goalOf(int lobeCount, double smoothing) {
    NodeGoal goal;
    goal.lobeCount = lobeCount;
    goal.smoothing = smoothing;
    return goal;
}

TEST(NodeFit, recoversALobeFromItsMoments) {
    const LobeSamples samples = samplesOf(oneLobe(), 1);
    const FitTerm term = termOf(samples);
    const ltc::TableNode start = momentNode(samples, ltc::TableLayout{}, kAxis);
    const ltc::TableNode found = fitNode(start, {&term, 1}, goalOf(1, 0.02));
    const ltc::LobeCode& code = found.codes[0];
    EXPECT_NEAR(code.stretch, 0.8, 1e-6);
    EXPECT_NEAR(code.tilt, -0.25, 1e-6);
    EXPECT_NEAR(code.shear, 0.2, 1e-6);
    EXPECT_NEAR(code.rootWidth, 0.7, 1e-6);
}

TEST(NodeFit, recoversTwoLobesFromNearby) {
    const LobeSamples samples = samplesOf(twoLobes(), 2);
    const FitTerm term = termOf(samples);
    ltc::TableNode start = twoLobes();
    start.codes[0].rootWidth *= 0.9;
    start.codes[1].tilt += 0.1;
    start.share2 = 0.5;
    const ltc::TableNode found = fitNode(start, {&term, 1}, goalOf(2, 0.02));
    EXPECT_LT(lobeError(samples, entryOf(found, 2)), 1e-3);
    EXPECT_GT(lobeError(samples, entryOf(start, 2)), 0.05);  // There was something to do.
}

TEST(NodeFit, aNodeThatIsAQuarterOfABlendMakesTheBlendFit) {
    // Three others are off by +d, +d and -d in the stored width; the fourth has to make up for it.
    const LobeSamples samples = samplesOf(oneLobe(), 1);
    FitTerm term{&samples, kAxis, 1.0, 0.25, zeroNode()};
    for (const double d : {0.02, 0.02, -0.02}) {
        ltc::TableNode other = oneLobe();
        other.codes[0].rootWidth += d;
        addLobes(term.others, other, 0.25);
    }
    const ltc::TableNode found = fitNode(oneLobe(), {&term, 1}, goalOf(1, 0.02));
    EXPECT_NEAR(found.codes[0].rootWidth, 0.7 - 0.02, 1e-5);
}

TEST(NodeFit, wishesPullAsTheyCount) {
    const LobeSamples samples = samplesOf(oneLobe(), 1);
    const FitTerm term = termOf(samples);
    NodeGoal goal = goalOf(1, 0.02);
    ltc::TableNode wide = oneLobe();
    wide.codes[0].rootWidth = 1.0;
    goal.wishes = {wide};
    goal.smoothness = 1e3;
    EXPECT_NEAR(fitNode(oneLobe(), {&term, 1}, goal).codes[0].rootWidth, 1.0, 1e-3);
    goal.smoothness = 1e-4;
    EXPECT_NEAR(fitNode(oneLobe(), {&term, 1}, goal).codes[0].rootWidth, 0.7, 1e-4);
}

/// The rootWidth of the best round lobe, by trying many.
double bestRootWidth(const LobeSamples& samples) {
    double best = 0.0;
    double bestError = 2.0;
    for (double rootWidth = 0.3; rootWidth < 1.5; rootWidth += 0.001) {
        ltc::TableEntry entry;
        entry.lobes[0] = ltc::decode({1.0, 0.0, 0.0, rootWidth}, {0.0, 1.0});
        const double error = lobeError(samples, entry);
        if (error >= bestError) continue;
        best = rootWidth;
        bestError = error;
    }
    return best;
}

TEST(NodeFit, roundLobesStayRound) {
    const LobeSamples samples = sampleLobe(brdf::Ggx(), 0.6, 1.0, 32);
    const FitTerm term{&samples, {0.0, 1.0}, 1.0, 1.0, zeroNode()};
    NodeGoal goal = goalOf(1, 0.02);
    goal.freedom = LobeFreedom::round;
    ltc::TableNode start;
    start.codes[0] = {1.2, 0.3, 0.1, 0.8};
    const ltc::LobeCode found = fitNode(start, {&term, 1}, goal).codes[0];
    EXPECT_EQ(found.stretch, 1.0);
    EXPECT_EQ(found.tilt, 0.0);
    EXPECT_EQ(found.shear, 0.0);
    EXPECT_NEAR(found.rootWidth, bestRootWidth(samples), 1e-2);
}

/// The objective by its definition.
double objective(const LobeSamples& samples, const ltc::TableNode& node, double smoothing) {
    double sum = 0.0;
    for (const LobeSamples::Point& point : samples.points) {
        const double scale = std::max(point.target, 1e-4);
        const double q = (modelDensity(point.direction, entryOf(node, 2)) - point.target) / scale;
        sum += point.area * scale * (std::sqrt(q * q + smoothing * smoothing) - smoothing);
    }
    return sum;
}

TEST(NodeFit, endsWhereNoSmallMoveHelps) {
    const LobeSamples samples = sampleLobe(brdf::Ggx(), 0.7, 0.6, 32);
    const FitTerm term = termOf(samples);
    const ltc::TableNode coarse = fitNode(twoLobes(), {&term, 1}, goalOf(2, 0.3));
    const ltc::TableNode found = fitNode(coarse, {&term, 1}, goalOf(2, 0.05));
    const double error = objective(samples, found, 0.05);
    EXPECT_LT(error, 0.9 * objective(samples, twoLobes(), 0.05));
    for (int lobe = 0; lobe < 2; ++lobe) {
        for (const double step : {-2e-3, 2e-3}) {
            for (const auto member : {&ltc::LobeCode::stretch, &ltc::LobeCode::tilt,
                                      &ltc::LobeCode::shear, &ltc::LobeCode::rootWidth}) {
                ltc::TableNode moved = found;
                moved.codes[lobe].*member += step;
                EXPECT_GT(objective(samples, moved, 0.05), error);
            }
        }
    }
}

}  // namespace
}  // namespace polylume::fit
