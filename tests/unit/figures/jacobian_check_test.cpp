// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "figures/jacobian_check.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polylume::figures {
namespace {

TEST(Jacobian, isOneForRotationsAndScales) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
    EXPECT_NEAR(solidAngleRatio(glm::dmat3(7.0), direction), 1.0, 1e-14);
    // A stretch along the direction by 2 draws everything together: 2 / 2^3.
    EXPECT_NEAR(solidAngleRatio(glm::dmat3(1, 0, 0, 0, 1, 0, 0, 0, 2), {0, 0, 1}), 0.25, 1e-14);
}

TEST(Jacobian, deviationFallsWithTheSquareOfTheStepUntilRounding) {
    const auto rows = checkJacobian(1000);
    ASSERT_EQ(rows.size(), 24u);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        if (rows[i].kind != rows[i - 1].kind) continue;
        // Rounding of double precision over the step, times the largest ratio of singular values
        // that comes up, is at most 1e-15 * 1e4 / step.
        const double rounding = 1e-11 / rows[i].step;
        EXPECT_LT(rows[i].mean, 0.5 * rows[i - 1].mean + rounding)
            << nameOf(rows[i].kind) << " " << rows[i].step;
    }
    // Between the steps 1e-2 and 1e-3 the table's matrices are in the regime of the square.
    EXPECT_NEAR(rows[1].mean / rows[2].mean, 100.0, 10.0);
    EXPECT_LT(rows[3].largest, 1e-4);
}

TEST(Jacobian, finiteDifferencesRefuteAnotherExponent) {
    const glm::dmat3 matrix(1.0, 0.2, 0.0, -0.3, 0.7, 0.1, 0.4, 0.0, 0.5);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, 0.6, 0.7));
    const double measured = measuredSolidAngleRatio(matrix, direction, 1e-4);
    EXPECT_NEAR(measured / solidAngleRatio(matrix, direction), 1.0, 1e-7);
    const double length = glm::length(matrix * direction);
    EXPECT_GT(std::abs(measured / (solidAngleRatio(matrix, direction) * length) - 1.0), 0.01);
}

}  // namespace
}  // namespace polylume::figures
