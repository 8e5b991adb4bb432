// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ltc/builtin_table.hpp"
#include "ltc/round_integral.hpp"
#include "ltc/round_outline.hpp"
#include "unit/ltc/lobes.hpp"
#include "unit/ltc/round_outlines.hpp"

namespace polylume::ltc::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// Rough to smooth lobes at normal to grazing views.
std::vector<Lobe> tableLobes() {
    std::vector<Lobe> lobes = {kCosine, kTilted, kGrazing};
    for (const double roughness : {0.02, 0.1, 0.3, 0.6, 1.0}) {
        for (const double cosTheta : {1.0, 0.6, 0.2, 0.02}) {
            lobes.push_back(ggx().lookup(roughness, cosTheta).lobes[0]);
        }
    }
    return lobes;
}

TEST(RoundLobe, identityGivesTheFormFactor) {
    RandomShapes random(21);
    for (int i = 0; i < 1000; ++i) {
        const EllipseShape ellipse = random.ellipse();
        const SphereShape sphere = random.sphere();
        const TubeShape tube = random.tube();
        EXPECT_NEAR(lobeFormFactor(ellipse, kCosine), formFactor(ellipse), 1e-14);
        EXPECT_NEAR(lobeFormFactor(sphere, kCosine), formFactor(sphere), 1e-14);
        EXPECT_NEAR(lobeFormFactor(tube, kCosine), formFactor(tube), 1e-14);
    }
}

TEST(RoundLobe, polygonsOfManySidesTendToEachShapeThroughBothHorizons) {
    RandomShapes random(22);
    int count = 0;
    int sharpCount = 0;
    int bothCount = 0;
    const auto check = [&](const auto& shape, const Lobe& lobe) {
        const Limit limit = limitFormFactor(shape, lobe);
        const double value = lobeFormFactor(shape, lobe);
        // A smooth lobe bends edges, so the oracle converges late.
        ASSERT_NEAR(value, limit.value, 1e-11 + 10.0 * limit.error) << "case " << count;
        ++count;
        sharpCount += limit.error < 1e-8;
        bothCount += std::abs(value) > 1e-3 && std::abs(value) < 0.999;
    };
    for (const Lobe& lobe : tableLobes()) {
        for (int i = 0; i < 12; ++i) {
            check(random.ellipse(), lobe);
            check(random.sphere(), lobe);
            check(random.tube(), lobe);
        }
    }
    EXPECT_GT(sharpCount, count * 8 / 10);
    EXPECT_GT(bothCount, count / 3);
}

TEST(RoundLobe, smallFarLightsAreTheDensityTimesTheirSolidAngle) {
    for (const Lobe& lobe : {kTilted, kGrazing, ggx().lookup(0.4, 0.6).lobes[0]}) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(-60.0, 10.0, 50.0));
        const double scale = lobeDensity(direction, lobe) / upperShare(lobe);
        for (const double distance : {1e4, 1e6, 1e8}) {
            const glm::dvec3 center = direction * distance;
            const double area = kPi / (distance * distance);
            // By the lobe's slope times the size.
            const double slope = 1e3 / distance;
            EXPECT_NEAR(lobeFormFactor(SphereShape{center, 1.0}, lobe) / (area * scale), 1.0,
                        slope);
            const EllipseShape ellipse{center, {2, 0, 0}, {0, 0.5, 0}};
            EXPECT_NEAR(-lobeFormFactor(ellipse, lobe) / (area * direction.z * scale), 1.0, slope);
            const TubeShape tube{center, center + glm::dvec3(0, 3, 0), 1.0};
            const double tubeArea = kPi + 6.0 * std::sqrt(1.0 - direction.y * direction.y);
            EXPECT_NEAR(lobeFormFactor(tube, lobe) / (area / kPi * tubeArea * scale), 1.0, slope);
        }
    }
}

/// 2 R times the integral of the density along a thin tube, above the surface, by a fine rule.
double lineIntegral(const glm::dvec3& start, const glm::dvec3& end, const Lobe& lobe) {
    constexpr int kSteps = 200000;
    const double length = glm::length(end - start);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 point = start + (end - start) * ((i + 0.5) / kSteps);
        if (point.z < 0.0) continue;
        const double distance = glm::length(point);
        const double sine = glm::length(glm::cross(point, end - start)) / (distance * length);
        sum += lobeDensity(point / distance, lobe) * sine / (distance * distance);
    }
    return 2.0 * sum * length / kSteps / upperShare(lobe);
}

TEST(RoundLobe, thinTubesAreLinesThroughBothHorizons) {
    RandomShapes random(23);
    for (const Lobe& lobe : tableLobes()) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 start = 2.0 * random.place();
            const glm::dvec3 end = 2.0 * random.place();
            if (glm::length(glm::cross(start, end)) < 0.3) continue;
            const double expected = lineIntegral(start, end, lobe);
            if (expected < 1e-3) continue;
            for (const double radius : {1e-6, 1e-8}) {
                // The steps at the horizons, the caps, and four angles that cancel.
                const double value = lobeFormFactor(TubeShape{start, end, radius}, lobe) / radius;
                EXPECT_NEAR(value / expected, 1.0, 1e-4 + 1e3 * radius) << radius;
            }
        }
    }
}

TEST(RoundLobe, nothingLeaksFromBehindTheSurface) {
    // Below the surface, but within the part of the lobe that hangs there.
    const SphereShape sphere{{-1.0, 0.0, -0.3}, 0.29};
    const EllipseShape ellipse{{-1.0, 0.0, -0.3}, {0, 0.5, 0}, {0, 0, 0.3}};
    const TubeShape tube{{-1.0, -1.0, -0.11}, {-1.0, 1.0, -0.11}, 0.1};
    EXPECT_EQ(lobeFormFactor(sphere, kGrazing), 0.0);
    EXPECT_EQ(lobeFormFactor(ellipse, kGrazing), 0.0);
    EXPECT_EQ(lobeFormFactor(tube, kGrazing), 0.0);
    // The broken twin without the surface clip sees it.
    const Rim rim(sphere.center, sphere.radius);
    const RoundOutline outline =
        RoundOutline::ofCone({rim.axis * rim.cosine, rim.u * rim.sine, rim.v * rim.sine});
    const HalfSpace horizon{{kGrazing.m31, 0.0, kGrazing.m33}, 1.0};
    EXPECT_GT(integrate(clipped(outline, horizon), kGrazing), 1e-3);
}

TEST(RoundLobe, smoothLimitIsWhetherTheMirrorRayHits) {
    for (const double cosTheta : {1.0, 0.8, 0.5, 0.2}) {
        const glm::dvec3 mirror(-std::sqrt(1.0 - cosTheta * cosTheta), 0.0, cosTheta);
        const Lobe lobe = ggx().lookup(0.0, cosTheta).lobes[0];
        const auto around = [&](double distance) {
            const glm::dvec3 center = mirror + glm::dvec3(0, distance, 0);
            const SphereShape sphere{center, 0.15};
            const EllipseShape disk{center, {0, 0.15, 0}, {0.15, 0, 0}};
            const TubeShape tube{center, center + glm::dvec3(0, distance, 0.0), 0.15};
            return std::vector<double>{lobeFormFactor(sphere, lobe), lobeFormFactor(disk, lobe),
                                       lobeFormFactor(tube, lobe)};
        };
        // The tails of alpha = 1e-4, which a grazing view draws out.
        for (const double value : around(0.0)) EXPECT_NEAR(value, 1.0, 2e-4) << cosTheta;
        for (const double value : around(0.3)) EXPECT_NEAR(value, 0.0, 2e-4) << cosTheta;
    }
}

TEST(RoundLobe, hugeLightsTakeTheWholeLobe) {
    for (const Lobe& lobe : tableLobes()) {
        // What a light 1e5 times wider than its height leaves free above the horizon.
        const double band =
            1.0 - lobeFormFactor(EllipseShape{{0, 0, 1}, {0, 1e5, 0}, {1e5, 0, 0}}, lobe);
        const double finer =
            1.0 - lobeFormFactor(EllipseShape{{0, 0, 1}, {0, 1e8, 0}, {1e8, 0, 0}}, lobe);
        EXPECT_NEAR(finer, band * 1e-3, 1e-12 + 1e-2 * std::abs(band));
        EXPECT_GE(band, -1e-12);
        EXPECT_LT(band, 0.2);
        // On the surface of a sphere or tube that is above.
        EXPECT_NEAR(lobeFormFactor(SphereShape{{0, 0, 1}, 1.0}, lobe), 1.0, 1e-12);
        EXPECT_NEAR(lobeFormFactor(TubeShape{{-3, 0, 1}, {4, 0, 1}, 1.0}, lobe), 1.0, 1e-12);
        // Inside of them.
        EXPECT_EQ(lobeFormFactor(SphereShape{{0, 0, 1}, 1.1}, lobe), -1.0);
        EXPECT_EQ(lobeFormFactor(TubeShape{{-3, 0, 1}, {4, 0, 1}, 1.1}, lobe), -1.0);
    }
}

TEST(RoundLobe, mirroredAndRenamedLightsAreTheSame) {
    RandomShapes random(24);
    for (const Lobe& lobe : tableLobes()) {
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 mirror(1.0, -1.0, 1.0);
            const SphereShape sphere = random.sphere();
            EXPECT_NEAR(lobeFormFactor(SphereShape{sphere.center * mirror, sphere.radius}, lobe),
                        lobeFormFactor(sphere, lobe), 1e-11);
            const EllipseShape ellipse = random.ellipse();
            const EllipseShape image{ellipse.center * mirror, ellipse.halfAxisX * mirror,
                                     -ellipse.halfAxisY * mirror};
            EXPECT_NEAR(lobeFormFactor(image, lobe), lobeFormFactor(ellipse, lobe), 1e-11);
            const TubeShape tube = random.tube();
            EXPECT_NEAR(lobeFormFactor(
                            TubeShape{tube.end * mirror, tube.start * mirror, tube.radius}, lobe),
                        lobeFormFactor(tube, lobe), 1e-11);
        }
    }
}

TEST(RoundLobe, twoLobesCountByTheirShares) {
    TableEntry entry;
    entry.lobeCount = 2;
    entry.lobes = {kTilted, kGrazing};
    entry.shares = {0.25, 0.75};
    const auto check = [&](const auto& light) {
        EXPECT_NEAR(lobeFormFactor(light, entry),
                    0.25 * lobeFormFactor(light, kTilted) + 0.75 * lobeFormFactor(light, kGrazing),
                    1e-15);
    };
    check(SphereShape{{-1, 0.2, 0.4}, 0.5});
    check(EllipseShape{{-1, 0.2, 0.4}, {0, 1, 0}, {0.5, 0, 0.2}});
    check(TubeShape{{-1, 0.2, 0.4}, {-2, -1, 0.3}, 0.1});
}

}  // namespace
}  // namespace polylume::ltc::testing
