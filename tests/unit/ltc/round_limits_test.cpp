// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ltc/builtin_table.hpp"
#include "ltc/round_integral.hpp"
#include "unit/ltc/round_outlines.hpp"

// Places where formulas for round lights fail: on the light, in its plane, inside, at its rim.
namespace polylume::ltc::testing {
namespace {

/// Of a half-space of directions about `axis`, unit, through a lobe.
double halfSpaceFactor(const glm::dvec3& axis, const Lobe& lobe) {
    // A sphere that is touched is all of one.
    return lobeFormFactor(SphereShape{axis, 1.0}, lobe);
}

TEST(RoundLimits, onASphereOrTubeItFillsItsHalfSpace) {
    RandomShapes random(31);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 axis = random.direction();
        const double expected = 0.5 * (1.0 + axis.z);
        // Offsets that rounding alone has, some inside: a true jump, by definition.
        for (const double gap : {1e-15, 1e-12, 1e-9, 1e-6}) {
            const double reached = 2.0 * std::sqrt(gap) + 1e-12;
            EXPECT_NEAR(formFactor(SphereShape{axis * (1.0 + gap), 1.0}), expected, reached);
            const glm::dvec3 along = glm::normalize(glm::cross(axis, random.direction()));
            const glm::dvec3 foot = axis * (1.0 + gap);
            const TubeShape tube{foot - along * random.size(10.0), foot + along * random.size(10.0),
                                 1.0};
            EXPECT_NEAR(formFactor(tube), expected, 10.0 * reached) << gap;
            EXPECT_EQ(formFactor(SphereShape{axis * (1.0 - gap), 1.0}), -1.0);
        }
    }
    EXPECT_NEAR(formFactor(SphereShape{{0, 0, 1}, 1.0}), 1.0, 1e-15);
    EXPECT_EQ(formFactor(SphereShape{{0, 0, -1}, 1.0}), 0.0);
    EXPECT_NEAR(formFactor(SphereShape{{1, 0, 0}, 1.0}), 0.5, 1e-15);
    EXPECT_NEAR(formFactor(TubeShape{{-1, 0, 1}, {5, 0, 1}, 1.0}), 1.0, 1e-15);
    EXPECT_EQ(formFactor(TubeShape{{-1, 0, -1}, {5, 0, -1}, 1.0}), 0.0);
    EXPECT_NEAR(formFactor(TubeShape{{1, 0, -3}, {1, 0, 2}, 1.0}), 0.5, 1e-15);
}

TEST(RoundLimits, insideIsTheBackAllAround) {
    const Lobe lobe{0.4, 0.5, -0.12, 0.2};
    for (const glm::dvec3& center : {glm::dvec3(0.0), glm::dvec3(0.5, 0, -0.5)}) {
        EXPECT_EQ(formFactor(SphereShape{center, 1.0}), -1.0);
        EXPECT_EQ(lobeFormFactor(SphereShape{center, 1.0}, lobe), -1.0);
        EXPECT_EQ(formFactor(TubeShape{center, center, 1.0}), -1.0);
        EXPECT_EQ(formFactor(TubeShape{center, center + glm::dvec3(0, 0, 9), 1.0}), -1.0);
        EXPECT_EQ(lobeFormFactor(TubeShape{center - glm::dvec3(0, 7, 0), center, 1.0}, lobe), -1.0);
    }
    // In the middle of a tube, away from its ends.
    EXPECT_EQ(formFactor(TubeShape{{-5, 0, 0.3}, {5, 0, 0.3}, 1.0}), -1.0);
}

TEST(RoundLimits, inTheDisksPlaneItIsEdgeOn) {
    const Lobe lobe{0.4, 0.5, -0.12, 0.2};
    const glm::dvec3 u(0.6, 0.0, 0.8);
    const glm::dvec3 v(0.0, 1.0, 0.0);
    // Inside, on its rim, beside.
    for (const double place : {0.0, 0.5, 1.0, 3.0, 1e5}) {
        EXPECT_EQ(formFactor(EllipseShape{u * place, u, v}), 0.0);
        EXPECT_EQ(lobeFormFactor(EllipseShape{u * place, u, v}, lobe), 0.0);
    }
    // No area, no radius.
    EXPECT_EQ(formFactor(EllipseShape{{0, 0, 1}, {0, 0, 0}, v}), 0.0);
    EXPECT_EQ(formFactor(EllipseShape{{0, 0, 1}, v, v}), 0.0);
    EXPECT_EQ(formFactor(SphereShape{{0, 0, 1}, 0.0}), 0.0);
    EXPECT_EQ(formFactor(TubeShape{{0, 0, 1}, {1, 0, 1}, 0.0}), 0.0);
    // Just off it, inside of the rim: a half-space of either sign.
    const glm::dvec3 normal = glm::cross(u, v);
    for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const double above = formFactor(EllipseShape{u * 0.4 + normal * gap, u, v});
        const double below = formFactor(EllipseShape{u * 0.4 - normal * gap, u, v});
        EXPECT_NEAR(above, -0.5 * (1.0 + normal.z), 3.0 * gap + 1e-9);
        EXPECT_NEAR(below, 0.5 * (1.0 - normal.z), 3.0 * gap + 1e-9);
        EXPECT_NEAR(lobeFormFactor(EllipseShape{u * 0.4 - normal * gap, u, v}, lobe),
                    halfSpaceFactor(-normal, lobe), 100.0 * gap + 1e-9);
        // Beside it, next to nothing.
        EXPECT_NEAR(formFactor(EllipseShape{u * 2.0 + normal * gap, u, v}), 0.0, gap);
    }
}

TEST(RoundLimits, rimThatTouchesTheHorizon) {
    // From above all of it, from below nothing, to the root of the rounding.
    for (const double tilt : {0.0, 0.5, 1.2}) {
        const glm::dvec3 u(0.0, 1.0, 0.0);
        const glm::dvec3 v(-std::sin(tilt), 0.0, std::cos(tilt));
        const glm::dvec3 touching(2.0, 0.3, v.z);
        const double whole = formFactor(EllipseShape{touching, u, v});
        for (const double gap : {1e-18, 1e-15, 1e-9, 1e-6}) {
            const glm::dvec3 step(0.0, 0.0, gap);
            EXPECT_NEAR(formFactor(EllipseShape{touching + step, u, v}), whole, 2.0 * gap + 1e-14);
            EXPECT_NEAR(formFactor(EllipseShape{touching - step, u, v}), whole, 2.0 * gap + 1e-14);
            const glm::dvec3 below(2.0, 0.3, -v.z);
            EXPECT_NEAR(formFactor(EllipseShape{below + step, u, v}), 0.0, gap + 1e-14);
            EXPECT_EQ(formFactor(EllipseShape{below - glm::dvec3(0, 0, 1e-13) - step, u, v}), 0.0);
        }
        EXPECT_GT(std::abs(whole), 0.01);
    }
    EXPECT_EQ(formFactor(SphereShape{{2, 0, -1}, 1.0}), 0.0);
    EXPECT_NEAR(formFactor(TubeShape{{2, 0, -1}, {3, 4, -1}, 1.0}), 0.0, 1e-16);
}

/// A lobe that is none, one that leans, and one that is partly below the surface.
const Lobe kTouchLobes[] = {Lobe{}, {0.4, 0.5, -0.12, 0.2}, {0.07, 0.26, -0.03, 0.09}};

/// Checks lights that `make` puts at a signed distance along a plane's normal, where they touch it
/// at 0, from inside: at 0 and by a rounding off it they are what they are next to it, and seen.
template <typename Make>
void expectWhole(const Make& make, const Lobe& lobe, double tolerance) {
    const double whole = lobeFormFactor(make(1e-9), lobe);
    EXPECT_GT(std::abs(whole), 1e-5);
    for (const double gap : {0.0, 1e-18, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11}) {
        EXPECT_NEAR(lobeFormFactor(make(gap), lobe), whole, tolerance) << gap;
        EXPECT_NEAR(lobeFormFactor(make(-gap), lobe), whole, tolerance) << -gap;
    }
}

/// The same of lights that touch the plane from outside: nothing is seen of them.
template <typename Make>
void expectNothing(const Make& make, const Lobe& lobe) {
    for (const double gap : {0.0, 1e-18, 1e-16, 1e-15, 1e-14, 1e-13}) {
        EXPECT_NEAR(lobeFormFactor(make(-gap), lobe), 0.0, 1e-14) << gap;
    }
    EXPECT_EQ(lobeFormFactor(make(-1e-11), lobe), 0.0);
}

TEST(RoundLimits, aSphereThatTouchesTheSurfaceIsWhole) {
    // cos / pi over a cap above the horizon: sin^2 of its half angle times the cosine to its axis.
    for (const glm::dvec2 place : {glm::dvec2(0.0, -0.92), {0.7, 0.0}, {-0.3, 2.1}, {40.0, -9.0}}) {
        for (const double radius : {1.25, 1.0, 0.1, 1e-3}) {
            const glm::dvec3 center(place, radius);
            const double distance = glm::length(center);
            const double expected = std::pow(radius / distance, 3.0);
            EXPECT_NEAR(formFactor(SphereShape{center, radius}), expected, 1e-14);
            EXPECT_NEAR(formFactor(SphereShape{center * glm::dvec3(1, 1, -1), radius}), 0.0, 1e-16);
        }
    }
}

TEST(RoundLimits, wholeLoopsThatTouchAHorizonStay) {
    for (const Lobe& lobe : kTouchLobes) {
        // The surface, and the lobe's own horizon where that is the one that cuts first, at +x.
        const glm::dvec3 up(0.0, 0.0, 1.0);
        const glm::dvec3 leaning = glm::normalize(glm::dvec3(lobe.m31, 0.0, lobe.m33));
        for (const auto& [normal, side] : {std::pair(up, -1.0), {leaning, 1.0}}) {
            const glm::dvec3 y(0.0, 1.0, 0.0);
            const glm::dvec3 x = side * glm::cross(y, normal);
            for (const double aside : {0.0, -0.92, 0.4}) {
                const glm::dvec3 foot = 1.3 * x + aside * y;
                const auto sphere = [&](double gap) {
                    return SphereShape{foot + normal * (0.8 + gap), 0.8};
                };
                expectWhole(sphere, lobe, 1e-8);
                // Rims that touch with their end of an axis, and with another point.
                for (const double turn : {0.0, 0.5, 1.0}) {
                    const glm::dvec3 u = normal * std::cos(turn) + y * std::sin(turn);
                    const glm::dvec3 v = y * std::cos(turn) - normal * std::sin(turn);
                    const double reach = std::hypot(0.5 * std::cos(turn), 0.3 * std::sin(turn));
                    const auto ellipse = [&](double gap) {
                        return EllipseShape{foot + normal * (reach + gap), 0.5 * u, 0.3 * v};
                    };
                    expectWhole(ellipse, lobe, 1e-8);
                }
                // Along the plane, upright, at an angle, and seen along itself.
                for (const glm::dvec3& step : {y, normal, y + 0.5 * normal, x + 0.5 * normal,
                                               foot + 0.2 * normal, 3.0 * x}) {
                    const auto tube = [&](double gap) {
                        const glm::dvec3 start = foot + normal * (0.2 + gap);
                        return TubeShape{start, start + step, 0.2};
                    };
                    expectWhole(tube, lobe, 1e-8);
                }
            }
        }
    }
}

TEST(RoundLimits, lightsThatTouchAHorizonFromOutsideAreNotSeen) {
    for (const Lobe& lobe : kTouchLobes) {
        const glm::dvec3 up(0.0, 0.0, 1.0);
        const glm::dvec3 leaning = glm::normalize(glm::dvec3(lobe.m31, 0.0, lobe.m33));
        for (const auto& [normal, side] : {std::pair(up, -1.0), {leaning, 1.0}}) {
            const glm::dvec3 y(0.0, 1.0, 0.0);
            const glm::dvec3 x = side * glm::cross(y, normal);
            for (const double aside : {0.0, -0.92, 0.4}) {
                const glm::dvec3 foot = 1.3 * x + aside * y;
                expectNothing(
                    [&](double gap) {
                        return SphereShape{foot - normal * (0.8 - gap), 0.8};
                    },
                    lobe);
                expectNothing(
                    [&](double gap) {
                        return EllipseShape{foot - normal * (0.5 - gap), 0.5 * normal, 0.3 * y};
                    },
                    lobe);
                for (const glm::dvec3& step : {y, -normal, y - 0.5 * normal, 3.0 * x}) {
                    expectNothing(
                        [&](double gap) {
                            const glm::dvec3 start = foot - normal * (0.2 - gap);
                            return TubeShape{start, start + step, 0.2};
                        },
                        lobe);
                }
            }
        }
    }
}

TEST(RoundLimits, farLightsThatTheHorizonHalvesKeepTheirDigits) {
    // The integral of z over the upper half of a unit disk is 2/3, over that of a square of sides 2
    // is 1; cos / pi of a point at height z is z / (pi d^3) per area. Beyond, rounding of d itself.
    for (const double distance : {1e3, 1e4, 1e6, 1e8, 1e10}) {
        const double scale = std::numbers::pi * std::pow(distance, 3.0);
        const double error = 6.0 / (distance * distance) + 1e-15 * distance;
        const glm::dvec3 front(0.6, 0.8, 0.0);
        const glm::dvec3 side(-0.8, 0.6, 0.0);
        const glm::dvec3 up(0.0, 0.0, 1.0);
        const glm::dvec3 center = distance * front;
        const double half = 2.0 / 3.0;
        EXPECT_NEAR(scale * formFactor(SphereShape{center, 1.0}), half, error);
        EXPECT_NEAR(-scale * formFactor(EllipseShape{center, side, up}), half, error);
        EXPECT_NEAR(scale * formFactor(TubeShape{center - side, center + side, 1.0}), half + 1.0,
                    10.0 * error);
        // A quarter of the disk's height above it: sin^3 of where it is cut.
        const double share = std::pow(1.0 - 0.25, 1.5);
        const double rest = half * share - 0.5 * (std::acos(0.5) - 0.5 * std::sqrt(0.75));
        EXPECT_NEAR(scale * formFactor(SphereShape{center - 0.5 * up, 1.0}), rest, error);
    }
}

TEST(RoundLimits, farLightsGoOverIntoNearOnes) {
    // Two ways to sum meet where a light is a tenth as wide as it is far.
    const Lobe lobe{0.4, 0.5, -0.12, 0.2};
    for (const double height : {0.0, 0.3, 5.0}) {
        for (const double width : {0.5, 1.0, 2.0}) {
            double previous = 0.0;
            double previousStep = 0.0;
            for (int i = 0; i < 200; ++i) {
                const glm::dvec3 center(-6.0 * (1.0 + 0.01 * i), 8.0 + 0.08 * i, height);
                const double value = lobeFormFactor(SphereShape{center, width}, lobe);
                const double step = value - previous;
                if (i > 1) {
                    EXPECT_NEAR(step, previousStep, 0.05 * std::abs(previousStep) + 1e-14);
                }
                previous = value;
                previousStep = step;
            }
        }
    }
}

/// The largest change between a thousand steps of a light, by `value` of 0 to 1, and over half as
/// many steps twice as long: a jump keeps its size, a slope halves.
struct Steps {
    double largest = 0.0;
    double coarse = 0.0;
};
template <typename Value>
Steps largestStep(const Value& value) {
    Steps steps;
    for (const int count : {4000, 2000}) {
        double previous = value(0.0);
        for (int i = 1; i <= count; ++i) {
            const double next = value(static_cast<double>(i) / count);
            double& largest = count == 4000 ? steps.largest : steps.coarse;
            largest = std::max(largest, std::abs(next - previous));
            previous = next;
        }
    }
    return steps;
}

TEST(RoundLimits, movingLightsDoNotJump) {
    std::vector<Lobe> lobes = {Lobe{}, Lobe{0.4, 0.5, -0.12, 0.2}, Lobe{0.07, 0.26, -0.03, 0.09}};
    lobes.push_back(builtinTable(BuiltinTable::ggx).lookup(0.3, 0.1).lobes[0]);
    const auto check = [](const char* name, const auto& value) {
        const Steps steps = largestStep(value);
        EXPECT_LT(steps.largest, 0.75 * steps.coarse + 1e-9) << name;
        EXPECT_GT(steps.largest, 0.0) << name;
    };
    for (const Lobe& lobe : lobes) {
        check("sphere through the surface", [&](double t) {
            return lobeFormFactor(SphereShape{{-1.5, 0.2, 2.0 - 4.0 * t}, 0.7}, lobe);
        });
        check("tube through the surface", [&](double t) {
            return lobeFormFactor(
                TubeShape{{-1.5, 0.2, 2.0 - 4.0 * t}, {-1.0, 1.2, 1.0 - 2.0 * t}, 0.3}, lobe);
        });
        check("ellipse through the surface", [&](double t) {
            const EllipseShape disk{{-1.5, 0.2, 2.0 - 4.0 * t}, {0.3, 0.5, 0.0}, {0.1, 0.0, 0.8}};
            return lobeFormFactor(disk, lobe);
        });
        check("tube that turns to be seen along itself", [&](double t) {
            const glm::dvec3 axis(std::sin(2.0 * t - 1.0), 0.1, std::cos(2.0 * t - 1.0));
            return lobeFormFactor(
                TubeShape{{-0.3, 0.0, 1.0}, glm::dvec3(-0.3, 0.0, 1.0) + axis, 0.2}, lobe);
        });
        check("ellipse that turns through its plane, beside", [&](double t) {
            const glm::dvec3 axis(std::cos(3.0 * t), 0.0, std::sin(3.0 * t));
            return lobeFormFactor(EllipseShape{{-2.0, 0.0, 1.0}, axis, {0.0, 0.7, 0.0}}, lobe);
        });
    }
}

}  // namespace
}  // namespace polylume::ltc::testing
