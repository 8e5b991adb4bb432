// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/lobe_model.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/ggx.hpp"
#include "ltc/polygon_integral.hpp"

namespace polylume::fit {
namespace {

const LobeShape kShape{0.6, -0.3, -1.2, 0.4};

double& component(ltc::TableEntry& entry, int index) {
    double* const members[] = {&entry.m11, &entry.m13, &entry.m31, &entry.m33};
    return *members[index];
}

double& component(LobeShape& shape, int index) {
    double* const members[] = {&shape.tilt, &shape.logStretch, &shape.logWidth, &shape.shear};
    return *members[index];
}

TEST(LobeModel, shapeAndMatrixAreEachOthersInverse) {
    const ltc::TableEntry entry = matrixOf(kShape);
    EXPECT_NEAR(entry.m11 * entry.m33 - entry.m13 * entry.m31, std::exp(-0.3 - 1.2), 1e-14);
    const LobeShape shape = shapeOf(entry);
    EXPECT_NEAR(shape.tilt, kShape.tilt, 1e-14);
    EXPECT_NEAR(shape.logStretch, kShape.logStretch, 1e-14);
    EXPECT_NEAR(shape.logWidth, kShape.logWidth, 1e-14);
    EXPECT_NEAR(shape.shear, kShape.shear, 1e-14);
}

TEST(LobeModel, lobeIsTheDensityOverItsUpperShare) {
    const ltc::TableEntry entry = matrixOf(kShape);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-0.5, 0.2, 0.6));
    EXPECT_NEAR(normalisedLobe(direction, entry, nullptr),
                ltc::lobeDensity(direction, entry) / ltc::upperShare(entry), 1e-13);
}

TEST(LobeModel, derivativesAreThoseOfFiniteDifferences) {
    constexpr double kStep = 1e-6;
    constexpr double kTolerance = 1e-8;  // Of central differences with that step.
    const ltc::TableEntry entry = matrixOf(kShape);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(-0.5, 0.2, 0.6));
    Eigen::Vector4d derivatives;
    normalisedLobe(direction, entry, &derivatives);
    const Eigen::Matrix4d byShape = matrixDerivatives(kShape);
    for (int i = 0; i < 4; ++i) {
        ltc::TableEntry above = entry;
        ltc::TableEntry below = entry;
        component(above, i) += kStep;
        component(below, i) -= kStep;
        EXPECT_NEAR((normalisedLobe(direction, above, nullptr) -
                     normalisedLobe(direction, below, nullptr)) /
                        (2.0 * kStep),
                    derivatives[i], kTolerance);
        LobeShape aboveShape = kShape;
        LobeShape belowShape = kShape;
        component(aboveShape, i) += kStep;
        component(belowShape, i) -= kStep;
        ltc::TableEntry aboveMatrix = matrixOf(aboveShape);
        ltc::TableEntry belowMatrix = matrixOf(belowShape);
        for (int j = 0; j < 4; ++j) {
            const double difference = component(aboveMatrix, j) - component(belowMatrix, j);
            EXPECT_NEAR(difference / (2.0 * kStep), byShape(j, i), kTolerance);
        }
    }
}

TEST(LobeModel, gradientOfTheObjectiveIsThatOfFiniteDifferences) {
    constexpr double kStep = 1e-6;
    const LobeSamples samples = sampleLobe(brdf::Ggx(), 0.6, 0.5, 24);
    const ltc::TableEntry entry = matrixOf(kShape);
    const Objective objective = evaluateObjective(samples, entry, 0.1);
    for (int i = 0; i < 4; ++i) {
        ltc::TableEntry above = entry;
        ltc::TableEntry below = entry;
        component(above, i) += kStep;
        component(below, i) -= kStep;
        const double difference = evaluateObjective(samples, above, 0.1).value -
                                  evaluateObjective(samples, below, 0.1).value;
        EXPECT_NEAR(difference / (2.0 * kStep), objective.gradient[i], 1e-6);
    }
}

TEST(LobeModel, errorOfTheSameLobeIsZeroAndOfOneFarAwayIsTwo) {
    LobeSamples samples = sampleLobe(brdf::Ggx(), 1.0, 0.5, 96);
    for (LobeSamples::Point& point : samples.points) {
        const double lobe = normalisedLobe(point.direction, matrixOf(kShape), nullptr);
        point.weight *= lobe / point.target;
        point.target = lobe;
    }
    std::erase_if(samples.points, [](const auto& point) { return !(point.target > 0.0); });
    EXPECT_NEAR(lobeError(samples, matrixOf(kShape)), 0.0, 1e-12);
    // Narrow, and on the other side: what overlaps is the two tails.
    const LobeShape away{-0.8, 0.0, -3.0, 0.0};
    EXPECT_NEAR(lobeError(samples, matrixOf(away)), 2.0, 0.2);
}

}  // namespace
}  // namespace polylume::fit
