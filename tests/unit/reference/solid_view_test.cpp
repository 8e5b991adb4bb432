// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/solid_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "light_samples.hpp"
#include "lights/plane_axes.hpp"
#include "ltc/polygon_integral.hpp"

// Balls and capsules as a point sees them, against outlines that are searched for.
namespace polylume::reference {
namespace {

constexpr double kPi = std::numbers::pi;

/// Around the origin of the frame, which is outside.
struct Case {
    std::string name;
    SolidEmitter solid;
    double formFactor = 0.0;
    std::vector<glm::dvec3> outline{};  ///< As outlineOf() has it.
};

SolidEmitter ball(const glm::dvec3& center, double radius) {
    return {center, glm::dvec3(0.0), radius, glm::dvec3(1.0)};
}

SolidEmitter tube(const glm::dvec3& start, const glm::dvec3& end, double radius) {
    return {start, end - start, radius, glm::dvec3(1.0)};
}

std::vector<Case> makeCases() {
    return {
        {"ball above", ball({0.3, 0.2, 1.2}, 0.7)},
        {"ball near", ball({0.1, -0.05, 0.5}, 0.5)},
        {"ball far", ball({30, 40, 60}, 0.7)},
        {"ball so far that it looks small", ball({300, 400, 600}, 0.7)},
        {"ball cut at the horizon", ball({1.5, 0.3, 0.2}, 0.7)},
        {"ball's cap above the horizon", ball({1.5, 0.3, -0.6}, 0.7)},
        {"tube above", tube({-1, 0.2, 1}, {1.2, 0.5, 1.4}, 0.2)},
        {"tube beside", tube({0.2, 0.3, 1}, {1.2, 0.5, 0.6}, 0.2)},
        {"tube near", tube({-1, 0.2, 0.3}, {1.2, 0.1, 0.25}, 0.2)},
        {"tube that points here", tube({0.2, 0.1, 1}, {0.9, 0.55, 4}, 0.15)},
        {"tube whose end hides it", tube({0.2, 0.1, 1}, {0.41, 0.18, 2}, 0.15)},
        {"tube whose end almost hides it", tube({0.2, 0, 1}, {0.2, 0.0001, 2}, 0.19999)},
        {"tube backwards", tube({4, 3, 5}, {1, 0.5, 1}, 0.4)},
        {"tube thick and short", tube({1, 0, 1}, {1.1, 0.1, 1}, 0.8)},
        {"tube cut at the horizon", tube({1, -0.8, -0.4}, {1.2, 0.6, 0.9}, 0.3)},
        {"tube along the horizon", tube({1, -1.5, 0.05}, {0.7, 2, -0.05}, 0.3)},
        {"tube from horizon to horizon", tube({-50, 0.2, 1}, {70, 0.5, 1.4}, 0.2)},
    };
}

/// Of the ray along the unit `direction` from the solid's axis: the distance from a point of the
/// axis to a ray is convex along it, so thirds lead to the least.
double distanceFromAxis(const SolidEmitter& solid, const glm::dvec3& direction) {
    const auto distance = [&](double share) {
        const glm::dvec3 point = solid.start + share * solid.axis;
        return glm::length(point - std::max(glm::dot(point, direction), 0.0) * direction);
    };
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 45; ++i) {
        const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
        if (distance(a) < distance(b)) {
            high = b;
        } else {
            low = a;
        }
    }
    return distance(low);
}

/// The outline as it is seen: one point in every of `count` directions around the nearest of the
/// axis, on the plane through that.
std::vector<glm::dvec3> outlineOf(const SolidEmitter& solid, int count) {
    const glm::dvec3 middle = solid.nearestOfAxis();
    const glm::dvec3 z = glm::normalize(middle);
    const auto [x, y] = PlaneAxes(z);
    std::vector<glm::dvec3> outline;
    for (int i = 0; i < count; ++i) {
        const double azimuth = 2.0 * kPi * (i + 0.5) / count;
        const glm::dvec3 aside = std::cos(azimuth) * x + std::sin(azimuth) * y;
        double in = 0.0, out = 0.5 * kPi;
        for (int k = 0; k < 45; ++k) {
            const double angle = 0.5 * (in + out);
            const glm::dvec3 direction = std::cos(angle) * z + std::sin(angle) * aside;
            (distanceFromAxis(solid, direction) < solid.radius ? in : out) = angle;
        }
        outline.push_back(z + std::tan(in) * aside);
    }
    return outline;
}

/// Counter-clockwise for a point below, as ltc::formFactor() counts.
double formFactorOf(const SolidEmitter& solid, int count) {
    return std::abs(ltc::formFactor(std::vector<ltc::Contour>{outlineOf(solid, count)}));
}

/// With what is searched for, once.
const std::vector<Case>& cases() {
    static const std::vector<Case> found = [] {
        std::vector<Case> made = makeCases();
        for (Case& c : made) {
            // Outlines of equal steps: the error falls with their square.
            const double coarse = formFactorOf(c.solid, 300), fine = formFactorOf(c.solid, 600);
            c.formFactor = fine + (fine - coarse) / 3.0;
            c.outline = outlineOf(c.solid, 400);
        }
        return made;
    }();
    return found;
}

/// Of the outline's part above the horizon, and the integral of a density over it, by midpoints
/// over fans of triangles.
struct Sums {
    double solidAngle = 0.0, density = 0.0;
};

Sums sumOver(const Case& c, const LightView& view) {
    constexpr int kSteps = 200;
    const auto sides = static_cast<double>(c.outline.size());
    const glm::dvec3 z = glm::normalize(c.solid.nearestOfAxis());
    Sums sums;
    for (const glm::dvec3& vertex : c.outline) {
        const double radius = glm::length(vertex - z);
        for (int k = 0; k < kSteps; ++k) {
            // In polar coordinates of the plane.
            const double share = (k + 0.5) / kSteps;
            const glm::dvec3 point = z + share * (vertex - z);
            const double area = share / kSteps * radius * radius * 2.0 * kPi / sides;
            const double square = glm::dot(point, point);
            const double solidAngle = area / (square * std::sqrt(square));
            const glm::dvec3 direction = point / std::sqrt(square);
            if (!(direction.z > 0.0)) continue;
            sums.solidAngle += solidAngle;
            sums.density += view.find(direction).density * solidAngle;
        }
    }
    return sums;
}

class SolidViewTest : public testing::SamplingTest {};

TEST_P(SolidViewTest, densityIntegratesToOne) {
    for (const Case& c : cases()) {
        const AreaEmitter emitter = c.solid;
        const LightView view = viewOf(emitter);
        ASSERT_FALSE(view.isDark()) << c.name;
        std::mt19937_64 generator(9);
        std::uniform_real_distribution<double> unit;
        int hits = 0, above = 0;
        constexpr int kCount = 40000;
        for (int i = 0; i < kCount; ++i) {
            const double x = unit(generator), y = unit(generator);
            const LightSample sample = view.sample({x, y});
            if (!(sample.density > 0.0)) continue;
            ++hits;
            if (sample.direction.z > 0.0) ++above;
        }
        // Few samples miss; by area the hidden side does, and the density has no bound, so that the
        // sum over midpoints says nothing.
        EXPECT_GT(hits, (isByArea() ? 0.01 : 0.85) * kCount) << c.name;
        if (isByArea()) continue;
        // Four deviations of the share, and the outline's steps.
        const double share = static_cast<double>(above) / kCount;
        EXPECT_NEAR(sumOver(c, view).density, share, 0.006) << c.name;
    }
}

TEST_P(SolidViewTest, oneOverTheDensityIsTheSolidAngleInTheMean) {
    for (const Case& c : cases()) {
        const AreaEmitter emitter = c.solid;
        const LightView view = viewOf(emitter);
        const double expected = sumOver(c, view).solidAngle;
        const testing::Estimate found =
            testing::estimate(view, [](const LightSample&) { return 1.0; });
        EXPECT_NEAR(found.mean(), expected, 4.0 * found.error() + 0.01 * expected) << c.name;
    }
}

TEST_P(SolidViewTest, theCosineOverPiIsTheFormFactorInTheMean) {
    for (const Case& c : cases()) {
        const AreaEmitter emitter = c.solid;
        const testing::Estimate found = testing::estimate(
            viewOf(emitter),
            [](const LightSample& sample) { return sample.direction.z * std::numbers::inv_pi; });
        ASSERT_GT(c.formFactor, 0.0) << c.name;
        EXPECT_NEAR(found.mean(), c.formFactor, 4.5 * found.error() + 1e-4 * c.formFactor)
            << c.name;
        // So that the bound means something.
        EXPECT_LT(found.error(), (isByArea() ? 0.4 : 0.02) * c.formFactor) << c.name;
    }
}

TEST_P(SolidViewTest, findTellsWhatSampleTells) {
    std::mt19937_64 generator(8);
    std::uniform_real_distribution<double> unit;
    for (const Case& c : cases()) {
        const AreaEmitter emitter = c.solid;
        const LightView view = viewOf(emitter);
        int lost = 0;
        for (int i = 0; i < 2000; ++i) {
            const double x = unit(generator), y = unit(generator);
            const LightSample sample = view.sample({x, y});
            if (!(sample.density > 0.0)) continue;
            EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-9);
            const glm::dvec3 point = sample.distance * sample.direction;
            SolidEmitter moved = c.solid;
            moved.start -= point;
            EXPECT_NEAR(glm::length(moved.nearestOfAxis()), c.solid.radius,
                        1e-6 * c.solid.radius + 1e-12)
                << c.name;
            const LightSample found = view.find(sample.direction);
            if (!(found.density > 0.0)) {
                ++lost;
                continue;
            }
            // Where it is seen at a flat angle, a rounding moves it far: by area much.
            const double cosine = -glm::dot(sample.direction, c.solid.normalAt(point));
            const double tolerance = 1e-6 + (isByArea() ? 1e-12 / (cosine * cosine) : 0.0);
            if (tolerance > 1e-3 || c.solid.radius < 1e-6) continue;
            EXPECT_NEAR(found.density / sample.density, 1.0, tolerance) << c.name;
            EXPECT_NEAR(found.distance / sample.distance, 1.0, tolerance) << c.name;
        }
        EXPECT_LE(lost, 2) << c.name;  // On the outline itself.
    }
}

TEST_P(SolidViewTest, aTurnedFrameChangesNothing) {
    const glm::dvec3 z = glm::normalize(glm::dvec3(1, 2, -1));
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), z));
    const ShadingFrame frame{{3, -1, 2}, {x, glm::cross(z, x), z}};
    const SolidEmitter solid = tube({1, -0.8, -0.4}, {1.2, 0.6, 0.9}, 0.3);
    const AreaEmitter plain = solid;
    SolidEmitter moved = solid;
    moved.start = frame.position + frame.toWorld(solid.start);
    moved.axis = frame.toWorld(solid.axis);
    const AreaEmitter turned = moved;
    if (isByArea()) return;  // Points of the surface may be numbered otherwise.
    for (const glm::dvec2 random : {glm::dvec2(0.1, 0.2), {0.9, 0.5}, {0.45, 0.99}}) {
        const LightSample a = viewOf(plain).sample(random),
                          b = viewOf(turned, frame).sample(random);
        EXPECT_LT(glm::length(a.direction - b.direction), 1e-9);
        EXPECT_NEAR(a.density, b.density, 1e-9 * a.density);
        EXPECT_NEAR(a.distance, b.distance, 1e-9);
    }
}

TEST_P(SolidViewTest, fromInsideItIsEverywhereOrNowhere) {
    for (SolidEmitter solid : {ball({0.2, 0.1, -0.3}, 0.8), tube({-1, 0, 0.4}, {3, 1, 0.2}, 0.7),
                               tube({0.3, 0, 0.4}, {3, 1, 0.2}, 0.7)}) {
        AreaEmitter emitter = solid;
        EXPECT_TRUE(viewOf(emitter).isDark());
        solid.twoSided = true;
        emitter = solid;
        const LightView view = viewOf(emitter);
        ASSERT_FALSE(view.isDark());
        const testing::Estimate all =
            testing::estimate(view, [](const LightSample&) { return 1.0; });
        EXPECT_NEAR(all.mean(), 2.0 * kPi, 4.5 * all.error() + 1e-9);
        const testing::Estimate cosine = testing::estimate(
            view, [](const LightSample& sample) { return sample.direction.z / kPi; });
        EXPECT_NEAR(cosine.mean(), 1.0, 4.5 * cosine.error());
        EXPECT_LT(cosine.error(), 0.05);
        EXPECT_GT(view.find({0, 0, 1}).distance, 0.0);
    }
}

TEST_P(SolidViewTest, lightsBelowTheHorizonAreDark) {
    for (const SolidEmitter& solid : {ball({0.2, 0.1, -0.9}, 0.8), ball({0, 0, -0.8}, 0.8),
                                      tube({-1, 0, -0.8}, {3, 1, -0.71}, 0.7)}) {
        const AreaEmitter emitter = solid;
        EXPECT_TRUE(viewOf(emitter).isDark());
    }
}

TEST_P(SolidViewTest, smallAndFarLightsKeepTheirDigits) {
    // Solid angles of pi (r / d)^2 and of a line's 2 r times the integral over it.
    if (isByArea()) return;
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 2, 3));
    for (const double distance : {1e3, 1e6, 1e9}) {
        const AreaEmitter emitter = ball(distance * direction, 1e-2);
        const testing::Estimate found =
            testing::estimate(viewOf(emitter), [](const LightSample&) { return 1.0; });
        const double expected = kPi * 1e-4 / (distance * distance);
        EXPECT_NEAR(found.mean(), expected, 4.5 * found.error() + 1e-4 * expected) << distance;
        EXPECT_LT(found.error(), 0.02 * expected);
    }
    // Across the view, 1 m at a distance of 1 m: the integral of cos is 2 sin(atan(1/2)).
    for (const double radius : {1e-3, 1e-5, 1e-7, 1e-10}) {
        const AreaEmitter emitter = tube({-0.5, 0, 1}, {0.5, 0, 1}, radius);
        const testing::Estimate found =
            testing::estimate(viewOf(emitter), [](const LightSample&) { return 1.0; });
        const double expected = 2.0 * radius * 2.0 / std::sqrt(5.0);
        EXPECT_NEAR(found.mean(), expected, 4.5 * found.error() + 2.0 * radius * expected)
            << radius;
        EXPECT_LT(found.error(), 0.02 * expected);
    }
}

INSTANTIATE_TEST_SUITE_P(, SolidViewTest, ::testing::ValuesIn(testing::ways()), testing::wayName);

}  // namespace
}  // namespace polylume::reference
