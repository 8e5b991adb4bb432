// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "ltc/polygon_integral.hpp"
#include "unit/ltc/polygons.hpp"

namespace polylume::ltc::testing {
namespace {

constexpr double kPi = std::numbers::pi;
/// Sums of a few angles in double.
constexpr double kRounding = 1e-13;

TEST(FormFactor, parallelRectangleWithACornerAboveThePoint) {
    // Howell, catalogue of configuration factors, B-3: element to parallel rectangle a x b at c.
    for (const auto& [a, b, c] : {std::tuple{1.0, 1.0, 1.0}, {2.0, 0.5, 0.3}, {0.1, 5.0, 2.0}}) {
        const double x = a / c;
        const double y = b / c;
        const double rootX = std::sqrt(1.0 + x * x);
        const double rootY = std::sqrt(1.0 + y * y);
        const double expected =
            (x / rootX * std::atan(y / rootX) + y / rootY * std::atan(x / rootY)) / (2.0 * kPi);
        EXPECT_NEAR(formFactor(rectangle(0.0, a, 0.0, b, c)), expected, kRounding);
    }
}

TEST(FormFactor, perpendicularRectangleThatTouchesTheHorizon) {
    // Howell B-4: element to a perpendicular rectangle, width b, height a, its lower corner at
    // distance c along the normal of the rectangle.
    for (const auto& [a, b, c] : {std::tuple{1.0, 1.0, 1.0}, {2.0, 0.5, 0.3}, {0.1, 5.0, 2.0}}) {
        const double x = a / b;
        const double y = c / b;
        const double root = std::sqrt(x * x + y * y);
        const double expected =
            (std::atan(1.0 / y) - y / root * std::atan(1.0 / root)) / (2.0 * kPi);
        // In the plane x = c, facing -x.
        const Polygon wall = {{{c, 0, 0}, {c, 0, a}, {c, b, a}, {c, b, 0}}};
        EXPECT_NEAR(formFactor(wall), expected, kRounding);
        // What lies below the horizon adds nothing.
        const Polygon sunken = {{{c, 0, -a}, {c, 0, a}, {c, b, a}, {c, b, -a}}};
        EXPECT_NEAR(formFactor(sunken), expected, kRounding);
    }
}

TEST(FormFactor, squareThatIsFarWiderThanItsHeightFillsTheHemisphere) {
    EXPECT_NEAR(formFactor(rectangle(-5e4, 5e4, -5e4, 5e4, 1.0)), 1.0, 1e-6);
}

TEST(FormFactor, polygonOfManySidesTendsToTheDisk) {
    // Coaxial disk: R^2 / (R^2 + h^2). Off axis, parallel: (1 - (h^2 + d^2 - R^2) / root) / 2
    // (B-13).
    const double height = 0.7;
    const double radius = 1.3;
    const double distance = 0.9;
    EXPECT_NEAR(formFactor(disk(0.0, height, radius, 4096, true)),
                radius * radius / (radius * radius + height * height), 1e-6);
    const double p = height * height + distance * distance;
    const double root =
        std::sqrt(std::pow(p + radius * radius, 2.0) - 4.0 * radius * radius * distance * distance);
    const double expected = 0.5 * (1.0 - (p - radius * radius) / root);
    EXPECT_NEAR(formFactor(disk(distance, height, radius, 4096, true)), expected, 1e-6);
    // Of second order in the number of sides.
    const double coarse =
        std::abs(formFactor(disk(distance, height, radius, 64, false)) - expected);
    const double fine = std::abs(formFactor(disk(distance, height, radius, 128, false)) - expected);
    EXPECT_NEAR(coarse / fine, 4.0, 0.05);
}

TEST(FormFactor, splittingRotatingReversing) {
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 offset(uniform(generator), uniform(generator), 1.2 * uniform(generator));
        const glm::dmat3 turn = rotation(
            {uniform(generator), uniform(generator), uniform(generator)}, 3.0 * uniform(generator));
        const auto placed = [&](const Polygon& p) { return transformed(p, turn, offset); };
        const Polygon whole = placed(rectangle(-1, 1, -1, 1, 0.3));
        const double value = formFactor(whole);
        EXPECT_NEAR(formFactor(placed(rectangle(-1, 0.2, -1, 1, 0.3))) +
                        formFactor(placed(rectangle(0.2, 1, -1, 1, 0.3))),
                    value, 1e-11);
        EXPECT_NEAR(formFactor(reversed(whole)), -value, kRounding);
        Polygon shifted = whole;
        std::rotate(shifted[0].begin(), shifted[0].begin() + 1, shifted[0].end());
        EXPECT_NEAR(formFactor(shifted), value, kRounding);
        // About the normal nothing changes.
        EXPECT_NEAR(formFactor(transformed(whole, rotation({0, 0, 1}, 1.0), glm::dvec3(0.0))),
                    value, 1e-11);
    }
}

TEST(FormFactor, concaveOutlinesAndHolesAreExactAcrossTheHorizon) {
    std::mt19937_64 generator(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    int crossings = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 offset(2.0 * uniform(generator), uniform(generator), uniform(generator));
        const glm::dmat3 turn = rotation(
            {uniform(generator), uniform(generator), uniform(generator)}, 3.0 * uniform(generator));
        const auto placed = [&](const Polygon& p) { return transformed(p, turn, offset); };
        const Polygon outline = placed(concave(0.4));
        const auto below = [](const glm::dvec3& v) { return v.z < 0.0; };
        crossings += std::any_of(outline[0].begin(), outline[0].end(), below);
        const double parts = formFactor(placed(rectangle(-1, 0, -1, 2, 0.4))) +
                             formFactor(placed(rectangle(0, 2, -1, 0, 0.4)));
        ASSERT_NEAR(formFactor(outline), parts, 1e-11);

        // A square with a hole is the outer less the inner square.
        const Polygon outer = placed(rectangle(-1, 1, -1, 1, 0.4));
        const Polygon inner = placed(rectangle(-0.5, 0.3, -0.2, 0.6, 0.4));
        const Polygon ring = {outer[0], reversed(inner)[0]};
        ASSERT_NEAR(formFactor(ring), formFactor(outer) - formFactor(inner), 1e-11);
        // A hole that turns the same way is the mistake that this convention is there to see.
        const double wrong = formFactor(Polygon{outer[0], inner[0]});
        if (std::abs(formFactor(inner)) > 1e-6) {
            ASSERT_NE(wrong, formFactor(ring));
        }
    }
    EXPECT_GT(crossings, 500);
}

TEST(FormFactor, smallFarLightIsAPointLight) {
    const glm::dvec3 centre(300.0, 200.0, 400.0);
    const glm::dvec3 toPoint = -glm::normalize(centre);
    const glm::dvec3 u = glm::normalize(glm::cross(toPoint, glm::dvec3(0, 0, 1)));
    const glm::dvec3 v = glm::cross(toPoint, u);
    const double half = 0.01;
    const Polygon light = {{centre - half * u - half * v, centre + half * u - half * v,
                            centre + half * u + half * v, centre - half * u + half * v}};
    const double distance = glm::length(centre);
    const double expected = -toPoint.z * 4.0 * half * half / (kPi * distance * distance);
    // Cancellation of angles of 4e-5 whose sum is 1e-10.
    EXPECT_NEAR(formFactor(light) / expected, 1.0, 1e-5);
}

TEST(FormFactor, isZeroInTheLightsPlaneAndForNoArea) {
    const Polygon wall = {{{0, -1, -1}, {0, -1, 1}, {0, 1, 1}, {0, 1, -1}}};
    EXPECT_EQ(formFactor(wall), 0.0);                                            // Inside of it.
    EXPECT_EQ(formFactor(transformed(wall, glm::dmat3(1.0), {0, 1, 0})), 0.0);   // On its edge.
    EXPECT_EQ(formFactor(transformed(wall, glm::dmat3(1.0), {0, 1, -1})), 0.0);  // At a vertex.
    EXPECT_EQ(formFactor(transformed(wall, glm::dmat3(1.0), {0, 5, 0})), 0.0);   // Beside it.
    EXPECT_EQ(formFactor(rectangle(-1, 1, -1, 1, 0.0)), 0.0);
    EXPECT_EQ(formFactor(rectangle(-1, 1, 0.5, 0.5, 1.0)), 0.0);
    EXPECT_EQ(formFactor(Polygon{}), 0.0);
    EXPECT_EQ(formFactor(Polygon{{}}), 0.0);
    EXPECT_EQ(formFactor(Polygon{{{0, 0, 1}}}), 0.0);
    EXPECT_EQ(formFactor(Polygon{{{0, 0, 1}, {1, 0, 1}}}), 0.0);
    // Just off the plane it is nearly half a hemisphere's, of either sign.
    EXPECT_NEAR(formFactor(transformed(wall, glm::dmat3(1e3), {1e-6, 0, 0})), 0.5, 1e-6);
    EXPECT_NEAR(formFactor(transformed(wall, glm::dmat3(1e3), {-1e-6, 0, 0})), -0.5, 1e-6);
}

}  // namespace
}  // namespace polylume::ltc::testing
