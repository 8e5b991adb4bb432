// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/quadrature.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace polylume::brdf {
namespace {

template <typename Function>
double integrate(const std::vector<QuadratureNode>& rule, Function function) {
    double sum = 0.0;
    for (const QuadratureNode& node : rule) sum += node.weight * function(node.position);
    return sum;
}

TEST(Quadrature, gaussLegendreIsExactForPolynomialsUpToTwiceItsNodesLessOne) {
    for (const int count : {1, 2, 3, 8, 33, 64}) {
        const int degree = 2 * count - 1;
        const auto power = [&](double x) { return std::pow(x, degree); };
        EXPECT_NEAR(integrate(gaussLegendre(count), power), 1.0 / (degree + 1), 1e-14);
    }
}

TEST(Quadrature, gaussLegendreIsNotExactOneDegreeFurther) {
    const auto power = [](double x) { return std::pow(x, 6); };
    EXPECT_GT(std::abs(integrate(gaussLegendre(3), power) - 1.0 / 7.0), 1e-5);
}

TEST(Quadrature, tanhSinhIntegratesRootsThatAreVerticalAtTheEnds) {
    const auto circle = [](double x) { return std::sqrt(x * (1.0 - x)); };
    EXPECT_NEAR(integrate(tanhSinh(48), circle), std::acos(-1.0) / 8.0, 1e-9);
    const auto inverseRoot = [](double x) { return 1.0 / std::sqrt(x); };
    // The range of the rule cuts off positions below 1e-14.
    EXPECT_NEAR(integrate(tanhSinh(96), inverseRoot), 2.0, 1e-6);
}

}  // namespace
}  // namespace polylume::brdf
