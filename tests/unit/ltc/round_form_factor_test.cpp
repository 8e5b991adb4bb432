// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ltc/round_integral.hpp"
#include "unit/ltc/polygons.hpp"
#include "unit/ltc/round_outlines.hpp"

namespace polylume::ltc::testing {
namespace {

constexpr double kPi = std::numbers::pi;
/// Some roundings, of values up to 1 and relative for smaller ones.
constexpr double kRounding = 1e-14;

/// A disk that faces `normal`.
EllipseShape disk(const glm::dvec3& center, const glm::dvec3& normal, double radius) {
    const glm::dvec3 n = glm::normalize(normal);
    const glm::dvec3 u = glm::normalize(
        glm::cross(std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), n));
    return {center, u * radius, glm::cross(n, u) * radius};
}

TEST(RoundFormFactor, diskHeadOnAtAnyDistance) {
    for (const double height : {1e-12, 1e-6, 0.3, 1.0, 20.0, 1e5, 1e12}) {
        const double expected = 1.0 / (1.0 + height * height);
        const double value = formFactor(disk({0, 0, height}, {0, 0, -1}, 1.0));
        EXPECT_NEAR(value / expected, 1.0, kRounding) << height;
    }
}

TEST(RoundFormFactor, parallelDiskAside) {
    // Howell, catalogue of configuration factors, B-13.
    for (const double radius : {1e-6, 0.01, 1.3, 5.0, 1e5}) {
        const double height = 0.7;
        const double distance = 0.9;
        const double p = height * height + distance * distance;
        const double z = p + radius * radius;
        const double root = std::sqrt(z * z - 4.0 * radius * radius * distance * distance);
        // (1 - rest / root) / 2, for small disks without cancellation.
        const double rest = p - radius * radius;
        const double expected =
            rest > 0.0 ? 2.0 * radius * radius * height * height / (root * (root + rest))
                       : 0.5 * (1.0 - rest / root);
        const double value = formFactor(disk({distance, 0, height}, {0, 0, -1}, radius));
        EXPECT_NEAR(value / expected, 1.0, kRounding) << radius;
    }
}

TEST(RoundFormFactor, uprightDiskAboveTheHorizonAndTouchingIt) {
    // Howell B-12: the element in a plane at right angles to the disk's, below its center.
    for (const double radius : {1e-3, 0.4, 0.99, 1.0}) {
        const double height = 0.8;
        const double z = 1.0 + height * height + radius * radius;
        const double expected = 0.5 * height * (z / std::sqrt(z * z - 4.0 * radius * radius) - 1.0);
        const double value = formFactor(disk({height, 0, 1.0}, {-1, 0, 0}, radius));
        EXPECT_NEAR(value, expected, 1e-13) << radius;
    }
}

/// A sphere of radius 1 at distance `h`, seen under the angle `omega` from the normal (Hamilton and
/// Morgan 1952; Snyder 1996).
double sphereFormFactor(double h, double omega) {
    const double cosine = std::cos(omega);
    if (cosine * h >= 1.0) return cosine / (h * h);
    if (cosine * h <= -1.0) return 0.0;
    const double tangent = std::sqrt((h - 1.0) * (h + 1.0));
    const double sine = std::sin(omega);
    const double rest = std::sqrt(1.0 - h * h * cosine * cosine);
    const double first = (cosine * std::acos(-cosine * tangent / sine) - rest * tangent) / (h * h);
    return (first + std::atan2(rest, tangent)) / kPi;
}

TEST(RoundFormFactor, sphereAboveAcrossAndBelowTheHorizon) {
    for (const double h : {1.000001, 1.1, 2.0, 30.0}) {
        for (int i = 0; i <= 64; ++i) {
            const double omega = kPi * i / 64;
            for (const double azimuth : {0.0, 1.0, 4.0}) {
                const glm::dvec3 center(h * std::sin(omega) * std::cos(azimuth),
                                        h * std::sin(omega) * std::sin(azimuth),
                                        h * std::cos(omega));
                EXPECT_NEAR(formFactor(SphereShape{center, 1.0}), sphereFormFactor(h, omega), 1e-12)
                    << h << " " << omega;
            }
        }
    }
    // Its center on the horizon.
    EXPECT_NEAR(formFactor(SphereShape{{2, 0, 0}, 1.0}), sphereFormFactor(2.0, 0.5 * kPi),
                kRounding);
    EXPECT_GT(sphereFormFactor(2.0, 0.5 * kPi), 0.02);
}

TEST(RoundFormFactor, sphereFarAwayKeepsItsDigits) {
    for (const double distance : {1e2, 1e4, 1e6}) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.2, 0.7));
        const double expected = direction.z / (distance * distance);
        EXPECT_NEAR(formFactor(SphereShape{direction * distance, 1.0}) / expected, 1.0, kRounding);
        // Half of it: two terms of 1 / distance cancel to their cube.
        const double half = formFactor(SphereShape{{distance, 0, 0}, 1.0});
        EXPECT_NEAR(half / (2.0 / (3.0 * kPi * std::pow(distance, 3.0))), 1.0,
                    2.0 / (distance * distance) + 1e-15 * distance * distance);
    }
}

TEST(RoundFormFactor, sphereIsTheDiskThatItsRimSpans) {
    RandomShapes random(11);
    for (int i = 0; i < 2000; ++i) {
        const SphereShape sphere = random.sphere();
        const double ratio = sphere.radius / glm::length(sphere.center);
        const double cosine = std::sqrt(1.0 - ratio * ratio);
        const EllipseShape rim =
            disk(sphere.center * (cosine * cosine), -sphere.center, sphere.radius * cosine);
        EXPECT_NEAR(formFactor(sphere), formFactor(rim), kRounding);
        // The broken twin: the disk of the sphere's own center and radius.
        const EllipseShape wrong = disk(sphere.center, -sphere.center, sphere.radius);
        if (formFactor(sphere) > 0.01 && ratio > 0.3) {
            EXPECT_GT(std::abs(formFactor(sphere) - formFactor(wrong)), 1e-4);
        }
    }
}

TEST(RoundFormFactor, longTubeIsTheInfiniteCylinder) {
    // From an element to an infinite cylinder that is parallel: R / h times the cosine.
    for (const double ratio : {1e-6, 0.1, 0.5, 0.9}) {
        const glm::dvec3 toAxis(0.6, 0.0, 0.8);
        for (const double length : {1e4, 1e6}) {
            const TubeShape tube{toAxis - glm::dvec3(0, length, 0),
                                 toAxis + glm::dvec3(0, length, 0), ratio};
            if (0.8 * 1.0 < ratio) continue;  // Across the horizon.
            EXPECT_NEAR(formFactor(tube) / (0.8 * ratio), 1.0, 2.0 / (length * length) + 1e-9);
        }
    }
}

TEST(RoundFormFactor, thinTubeIsTheLine) {
    // 2 R / pi times the integral along the line of cos_p sin_l / r^2.
    const auto line = [](const glm::dvec3& start, const glm::dvec3& end) {
        const double length = glm::length(end - start);
        const glm::dvec3 axis = (end - start) / length;
        const double s = glm::dot(start, axis);
        const glm::dvec3 foot = start - axis * s;
        const double h = glm::length(foot);
        const auto even = [&](double x) {
            return x / (2.0 * h * h * (h * h + x * x)) + std::atan(x / h) / (2.0 * h * h * h);
        };
        const auto odd = [&](double x) { return -0.5 / (h * h + x * x); };
        return 2.0 / kPi * h *
               (foot.z * (even(s + length) - even(s)) + axis.z * (odd(s + length) - odd(s)));
    };
    RandomShapes random(12);
    for (int i = 0; i < 1000; ++i) {
        glm::dvec3 start = 3.0 * random.place();
        glm::dvec3 end = 3.0 * random.place();
        // Wholly above, and neither short nor seen along itself.
        start.z = 0.3 + std::abs(start.z);
        end.z = 0.3 + std::abs(end.z);
        if (glm::length(glm::cross(start, end)) < 0.3) continue;
        for (const double radius : {1e-6, 1e-9}) {
            const double value = formFactor(TubeShape{start, end, radius}) / radius;
            // The caps are as large as the radius; four angles of order 1 cancel to it.
            EXPECT_NEAR(value / line(start, end), 1.0, 30.0 * radius + 1e-14 / radius);
        }
    }
}

TEST(RoundFormFactor, tubeWithoutLengthIsTheSphere) {
    RandomShapes random(13);
    for (int i = 0; i < 1000; ++i) {
        const SphereShape sphere = random.sphere();
        const double expected = formFactor(sphere);
        EXPECT_EQ(formFactor(TubeShape{sphere.center, sphere.center, sphere.radius}), expected);
        for (const double length : {1e-3, 1e-8, 1e-15}) {
            const TubeShape tube{sphere.center, sphere.center + random.direction() * length,
                                 sphere.radius};
            EXPECT_NEAR(formFactor(tube), expected, 3.0 * length / sphere.radius + 1e-13);
        }
    }
}

TEST(RoundFormFactor, tubeSeenAlongItselfIsItsNearerEnd) {
    for (const double aside : {0.0, 0.2, 0.499999999}) {
        const TubeShape tube{{aside, 0, 2}, {aside, 0, 7}, 0.5};
        const double expected = formFactor(SphereShape{tube.start, 0.5});
        EXPECT_EQ(formFactor(tube), expected);
        EXPECT_EQ(formFactor(TubeShape{tube.end, tube.start, 0.5}), expected);
    }
    // And the rest comes into view without a jump.
    const auto at = [](double aside) {
        return formFactor(TubeShape{{aside, 0, 2}, {aside, 0, 7}, 0.5});
    };
    for (const double step : {1e-3, 1e-6, 1e-9, 1e-12}) {
        EXPECT_NEAR(at(0.5 + step), at(0.5 - step), step) << step;
    }
}

TEST(RoundFormFactor, polygonsOfManySidesTendToEachShape) {
    RandomShapes random(14);
    int sharpCount = 0;
    const int kCount = 200;
    const auto check = [&](const auto& shape) {
        const Limit limit = limitFormFactor(shape);
        EXPECT_NEAR(formFactor(shape), limit.value, 1e-12 + 8.0 * limit.error);
        sharpCount += limit.error < 1e-10;
    };
    for (int i = 0; i < kCount; ++i) {
        check(random.ellipse());
        check(random.sphere());
        check(random.tube());
    }
    EXPECT_GT(sharpCount, 3 * kCount * 8 / 10);  // Else the oracle says little.
}

TEST(RoundFormFactor, turningScalingAndRenamingChangeNothing) {
    RandomShapes random(15);
    for (int i = 0; i < 2000; ++i) {
        const glm::dmat3 turn = rotation({0, 0, 1}, 3.0 * random.uniform());
        const double scale = random.size(1e6);
        const EllipseShape e = random.ellipse();
        const double ellipseValue = formFactor(e);
        const auto placed = [&](const glm::dvec3& v) { return turn * v * scale; };
        const EllipseShape moved{placed(e.center), placed(e.halfAxisX), placed(e.halfAxisY)};
        // The conditioning of points close to the disk's plane.
        EXPECT_NEAR(formFactor(moved), ellipseValue, 1e-12);
        EXPECT_NEAR(formFactor(EllipseShape{e.center, e.halfAxisY, -e.halfAxisX}), ellipseValue,
                    1e-13);
        const double c = std::cos(scale);
        const double s = std::sin(scale);
        const EllipseShape conjugate{e.center, e.halfAxisX * c + e.halfAxisY * s,
                                     e.halfAxisY * c - e.halfAxisX * s};
        EXPECT_NEAR(formFactor(conjugate), ellipseValue, 1e-12);
        // Seen from the other side.
        EXPECT_NEAR(formFactor(EllipseShape{e.center, e.halfAxisY, e.halfAxisX}), -ellipseValue,
                    1e-13);

        const SphereShape sphere = random.sphere();
        EXPECT_NEAR(formFactor(SphereShape{placed(sphere.center), sphere.radius * scale}),
                    formFactor(sphere), 1e-13);
        const TubeShape tube = random.tube();
        const double tubeValue = formFactor(tube);
        EXPECT_NEAR(
            formFactor(TubeShape{placed(tube.start), placed(tube.end), tube.radius * scale}),
            tubeValue, 1e-12);
        EXPECT_NEAR(formFactor(TubeShape{tube.end, tube.start, tube.radius}), tubeValue, 1e-13);
    }
}

TEST(RoundFormFactor, bothHalvesOfSpaceAddUp) {
    // Above the surface plus above its reverse is without a horizon: of the vector irradiance,
    // whose z for a sphere is (R/d)^2 cos.
    RandomShapes random(16);
    for (int i = 0; i < 1000; ++i) {
        const SphereShape sphere = random.sphere();
        const double d = glm::length(sphere.center);
        const double expected = sphere.radius * sphere.radius * sphere.center.z / (d * d * d);
        const SphereShape mirrored{sphere.center * glm::dvec3(1, 1, -1), sphere.radius};
        EXPECT_NEAR(formFactor(sphere) - formFactor(mirrored), expected, 1e-13);
    }
}

TEST(RoundFormFactor, needleThinEllipseIsAStrip) {
    // Its width follows the ellipse: relative to the wide one, to the first order in the width.
    const glm::dvec3 center(0.4, 0.1, 0.9);
    const auto value = [&](double width) {
        return formFactor(
            EllipseShape{center, {0.3, 0.9, 0.2}, glm::dvec3(-0.9, 0.3, 0.0) * width});
    };
    const double reference = value(1e-3) / 1e-3;
    for (const double width : {1e-4, 1e-6, 1e-9}) {
        EXPECT_NEAR(value(width) / width / reference, 1.0, 2e-6);
    }
    EXPECT_NEAR(value(1e-6) / value(1e-9), 1e3, 1e-6);
    EXPECT_GT(std::abs(reference), 0.05);
}

}  // namespace
}  // namespace polylume::ltc::testing
