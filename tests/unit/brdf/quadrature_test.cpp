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

TEST(Quadrature, crowdedGaussLegendreIntegratesTheSame) {
    const auto power = [](double x) { return std::pow(x, 5); };
    // A polynomial of degree 17 after the substitution.
    EXPECT_NEAR(integrate(crowdedGaussLegendre(9), power), 1.0 / 6.0, 1e-14);
    // A step of width 1e-3 at the end: the plain rule of as many nodes steps over it.
    const auto layer = [](double x) { return x / (x + 1e-3); };
    const double expected = 1.0 - 1e-3 * std::log(1001.0);
    EXPECT_NEAR(integrate(crowdedGaussLegendre(32), layer), expected, 1e-6);
    EXPECT_GT(std::abs(integrate(gaussLegendre(32), layer) - expected), 1e-5);
}

TEST(Quadrature, spreadBetweenSharesNodesByLength) {
    const std::vector<QuadratureNode> rule = spreadBetween(gaussLegendre, 16, {0.0, 0.5, 0.5, 2.0});
    EXPECT_EQ(rule.size(), 16u);
    const auto kink = [](double x) { return std::abs(x - 0.5); };
    EXPECT_NEAR(integrate(rule, kink), 0.125 + 1.125, 1e-14);
    // An eighth at least.
    EXPECT_EQ(spreadBetween(gaussLegendre, 16, {0.0, 1e-6, 1.0}).size(), 18u);
}

}  // namespace
}  // namespace polylume::brdf
