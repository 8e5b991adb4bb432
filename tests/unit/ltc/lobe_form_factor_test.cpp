// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "unit/ltc/lobes.hpp"
#include "unit/ltc/polygons.hpp"

namespace polylume::ltc::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// Integral of the density over the sphere above `minZ`, by a product rule.
double densityIntegral(const Lobe& lobe, double minZ) {
    constexpr int kSteps = 2000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = minZ + (1.0 - minZ) * (i + 0.5) / kSteps;
        const double planar = std::sqrt(1.0 - z * z);
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = kPi * (j + 0.5) / kSteps;  // Half: symmetric in y.
            sum += lobeDensity({planar * std::cos(azimuth), planar * std::sin(azimuth), z}, lobe);
        }
    }
    return sum * (1.0 - minZ) * 2.0 * kPi / (static_cast<double>(kSteps) * kSteps);
}

TEST(Lobe, densityIntegratesToOneAndItsUpperPartToTheShare) {
    for (const Lobe& lobe : {kCosine, kTilted, kGrazing}) {
        // Midpoint rule of 2000 x 2000 with a kink at the lobe's own horizon.
        EXPECT_NEAR(densityIntegral(lobe, -1.0), 1.0, 2e-4);
        EXPECT_NEAR(densityIntegral(lobe, 0.0), upperShare(lobe), 2e-4);
    }
    EXPECT_LT(upperShare(kGrazing), 0.99);  // Else this test would see nothing.
    EXPECT_EQ(upperShare(kCosine), 1.0);
}

TEST(Lobe, identityGivesTheFormFactor) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 offset(uniform(generator), uniform(generator), uniform(generator));
        const Polygon light =
            transformed(concave(0.1), rotation({1.0, uniform(generator), 0.2}, 2.0), offset);
        EXPECT_NEAR(lobeFormFactor(light, kCosine), formFactor(light), 1e-13);
    }
}

/// The lobe in a band of 2e-5 radians (what a square 1e5 times wider than its height leaves, at
/// most sqrt(2) more at its corners than at its sides) above the horizon.
double bandAboveHorizon(const Lobe& lobe) {
    constexpr int kSteps = 10000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double azimuth = 2.0 * kPi * (i + 0.5) / kSteps;
        sum += lobeDensity({std::cos(azimuth), std::sin(azimuth), 0.0}, lobe);
    }
    return sum / kSteps * 2.0 * kPi * 2e-5 / upperShare(lobe);
}

TEST(Lobe, hugeSquareTakesTheWholeLobe) {
    const Polygon ceiling = rectangle(-5e4, 5e4, -5e4, 5e4, 1.0);
    std::vector<Lobe> lobes = {kCosine, kTilted, kGrazing};
    for (const double roughness : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
        for (const double cosTheta : {1.0, 0.7, 0.4, 0.1}) {
            lobes.push_back(ggx().lookup(roughness, cosTheta).lobes[0]);
        }
    }
    for (const Lobe& lobe : lobes) {
        const double value = lobeFormFactor(ceiling, lobe);
        EXPECT_LE(value, 1.0);
        EXPECT_NEAR(value, 1.0, 1e-6 + bandAboveHorizon(lobe));
    }
    EXPECT_LT(bandAboveHorizon(kGrazing), 1e-4);
}

/// The lobe over a polygon above the surface, by a fine rule over the polygon.
double integrateOverRectangle(double x0, double x1, double y0, double y1, double z,
                              const Lobe& lobe) {
    constexpr int kSteps = 600;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const glm::dvec3 point(x0 + (x1 - x0) * (i + 0.5) / kSteps,
                                   y0 + (y1 - y0) * (j + 0.5) / kSteps, z);
            const double distance = glm::length(point);
            const glm::dvec3 direction = point / distance;
            sum += lobeDensity(direction, lobe) * direction.z / (distance * distance);
        }
    }
    return sum * (x1 - x0) * (y1 - y0) / (static_cast<double>(kSteps) * kSteps) / upperShare(lobe);
}

TEST(Lobe, polygonIntegralIsTheDensityIntegratedOverIt) {
    for (const Lobe& lobe : {kTilted, kGrazing}) {
        const double expected = integrateOverRectangle(-3, 0.5, -1, 0.7, 0.8, lobe);
        const Polygon light = rectangle(-3, 0.5, -1, 0.7, 0.8);
        // Midpoint rule of 600 x 600.
        EXPECT_NEAR(lobeFormFactor(light, lobe), expected, 2e-5);
        EXPECT_GT(expected, 0.05);
    }
}

TEST(Lobe, nothingLeaksFromBehindTheSurface) {
    // Below the surface, but within the part of the lobe that hangs there.
    const Polygon below = {{{-1, -1, -0.01}, {-1, 1, -0.01}, {-1, 1, -2}, {-1, -1, -2}}};
    EXPECT_EQ(lobeFormFactor(below, kGrazing), 0.0);
    // The broken twin without the surface clip sees it: the same light turned into the lobe's
    // space.
    Polygon twin = below;
    for (glm::dvec3& v : twin[0]) {
        v = {kGrazing.m11 * v.x + kGrazing.m13 * v.z, v.y, kGrazing.m31 * v.x + kGrazing.m33 * v.z};
    }
    EXPECT_GT(std::abs(formFactor(twin)), 1e-3);
}

TEST(Lobe, splittingAndHolesAreExactThroughBothClips) {
    std::mt19937_64 generator(6);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 offset(uniform(generator), uniform(generator), uniform(generator));
        const glm::dmat3 turn = rotation(
            {uniform(generator), uniform(generator), uniform(generator)}, 3.0 * uniform(generator));
        const auto placed = [&](const Polygon& p) { return transformed(p, turn, offset); };
        for (const Lobe& lobe : {kTilted, kGrazing}) {
            const auto value = [&](const Polygon& p) { return lobeFormFactor(placed(p), lobe); };
            ASSERT_NEAR(value(concave(0.4)),
                        value(rectangle(-1, 0, -1, 2, 0.4)) + value(rectangle(0, 2, -1, 0, 0.4)),
                        1e-10);
            const Polygon outer = rectangle(-1, 1, -1, 1, 0.4);
            const Polygon inner = rectangle(-0.5, 0.3, -0.2, 0.6, 0.4);
            ASSERT_NEAR(value({outer[0], reversed(inner)[0]}), value(outer) - value(inner), 1e-10);
            ASSERT_NEAR(value(reversed(outer)), -value(outer), 1e-13);
        }
    }
}

TEST(Lobe, smallFarLightIsTheDensityTimesItsSolidAngle) {
    const double half = 0.01;
    for (const Lobe& lobe : {kTilted, kGrazing, ggx().lookup(0.4, 0.6).lobes[0]}) {
        const glm::dvec3 centre(-60.0, 10.0, 50.0);
        const Polygon light =
            rectangle(centre.x - half, centre.x + half, centre.y - half, centre.y + half, centre.z);
        const double distance = glm::length(centre);
        const double solidAngle = 4.0 * half * half * centre.z / (distance * distance * distance);
        const double expected =
            lobeDensity(centre / distance, lobe) * solidAngle / upperShare(lobe);
        // Cancellation of angles of 2e-4 whose sum is 1e-7 or less.
        EXPECT_NEAR(lobeFormFactor(light, lobe) / expected, 1.0, 1e-4);
    }
}

TEST(Lobe, smoothLimitIsWhetherTheMirrorRayHits) {
    const Table& table = ggx();
    for (const double cosTheta : {1.0, 0.8, 0.5, 0.2}) {
        const double sinTheta = std::sqrt(1.0 - cosTheta * cosTheta);
        const double hitX = -sinTheta / cosTheta;  // Of the mirror ray with z = 1.
        const Lobe lobe = table.lookup(0.0, cosTheta).lobes[0];
        // The tails of alpha = 1e-4, which a grazing view draws out.
        EXPECT_NEAR(lobeFormFactor(rectangle(hitX - 1, hitX + 1, -1, 1, 1), lobe), 1.0, 5e-5);
        EXPECT_NEAR(lobeFormFactor(rectangle(hitX + 0.5, hitX + 2, -1, 1, 1), lobe), 0.0, 5e-5);
    }
}

TEST(Lobe, twoLobesCountByTheirShares) {
    TableEntry entry;
    entry.lobeCount = 2;
    entry.lobes = {kTilted, kGrazing};
    entry.shares = {0.25, 0.75};
    const Polygon light = rectangle(-2, 0.5, -1, 1.5, 0.7);
    EXPECT_NEAR(lobeFormFactor(light, entry),
                0.25 * lobeFormFactor(light, kTilted) + 0.75 * lobeFormFactor(light, kGrazing),
                1e-15);
}

}  // namespace
}  // namespace polylume::ltc::testing
