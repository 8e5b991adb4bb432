// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "ltc/round_integral.hpp"
#include "unit/ltc/polygons.hpp"

namespace polylume::ltc::testing {
namespace {

/// Draws lights and views that are, more often than not, special: coordinates of 0, 1 and of many
/// magnitudes, repeated vertices, points in the light's plane, lights on the horizon.
class TrapSource {
  public:
    /// Sizes and distances are between 10^-`reach` and 10^`reach`, or among the special ones.
    explicit TrapSource(unsigned seed, double reach) : generator_(seed), reach_(reach) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(generator_); }

    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

    double coordinate() {
        const double far = std::pow(10.0, std::min(reach_, 6.0));
        const double special[] = {0.0,   -0.0,   1.0,   -1.0,   0.5, -0.5,
                                  1e-30, -1e-30, 1e-12, -1e-12, far, -far};
        switch (below(4)) {
            case 0:
                return special[below(std::size(special))];
            case 1:
                return below(5) - 2.0;
            case 2:
                return std::pow(10.0, reach_ * (2.0 * unit() - 1.0)) * (below(2) ? 1.0 : -1.0);
            default:
                return 2.0 * unit() - 1.0;
        }
    }

    glm::dvec3 vertex() {
        const double x = coordinate();
        const double y = coordinate();
        return {x, y, coordinate()};
    }

    /// A polygon of 3 to 6 vertices in one plane, with a hole one time in four.
    Polygon light() {
        const glm::dvec3 origin = vertex();
        const glm::dvec3 u = vertex();
        const glm::dvec3 v = vertex();
        Polygon polygon;
        for (int contour = 0; contour < (below(4) == 0 ? 2 : 1); ++contour) {
            polygon.emplace_back();
            const int count = 3 + below(4);
            for (int i = 0; i < count; ++i) {
                const bool repeats = i > 0 && below(8) == 0;
                const double s = below(3) - 1.0;
                polygon.back().push_back(repeats ? polygon.back().back()
                                                 : origin + s * u + (below(3) - 1.0) * v);
            }
        }
        return polygon;
    }

    /// A rectangle, or another parallelogram.
    Polygon parallelogram() {
        const glm::dvec3 corner = vertex();
        const auto [u, v] = axes();
        return {{corner, corner + u, corner + u + v, corner + v}};
    }

    EllipseShape ellipse() {
        const auto [u, v] = axes();
        if (below(3)) return {vertex(), u, v};
        // The point at special places of the ellipse itself: at or close to its center, its rim,
        // its plane.
        const glm::dvec3 aside = tiny() * glm::cross(u, v);
        return {(below(5) - 2.0) * 0.5 * u + tiny() * v + aside, u, v};
    }

    SphereShape sphere() {
        const glm::dvec3 center = vertex();
        return {center, radius(glm::length(center), std::abs(center.z))};
    }

    TubeShape tube() {
        const glm::dvec3 start = vertex();
        const glm::dvec3 step = below(4) ? vertex() : start * (below(5) - 2.0);
        const glm::dvec3 end = start + step;
        const double aside = glm::length(glm::cross(start, step)) / glm::length(step);
        return {start, end, radius(below(2) ? aside : glm::length(end), std::abs(start.z))};
    }

    double cosThetaView() {
        static constexpr double kSpecial[] = {0.0, 1.0, 1e-4, -0.5, 1e-30, 0.5, 1.0 - 1e-16};
        return below(2) ? kSpecial[below(std::size(kSpecial))] : unit();
    }

    double roughness() {
        static constexpr double kSpecial[] = {0.0, 1.0, 1e-9, 0.05, 1.0 / 63.0, 0.5};
        return below(2) ? kSpecial[below(std::size(kSpecial))] : unit();
    }

  private:
    struct Axes {
        glm::dvec3 u;
        glm::dvec3 v;
    };

    /// Two vectors, mostly at right angles, also a needle or nothing.
    Axes axes() {
        const glm::dvec3 u = vertex();
        const glm::dvec3 v = vertex();
        if (below(4) == 0) return {u, v};
        const glm::dvec3 normal = glm::cross(u, v);
        const double length = glm::length(normal);
        const glm::dvec3 across = length > 0.0 ? normal * (glm::length(v) / length) : normal;
        return {u, below(4) ? across : across * 1e-6};
    }

    double tiny() { return below(2) ? 0.0 : std::pow(10.0, -20.0 * unit()); }

    /// Near or at one of two distances, or anything.
    double radius(double distance, double height) {
        const double base = below(2) ? distance : height;
        switch (below(4)) {
            case 0:
                return base;
            case 1:
                return base * (1.0 + (below(2) ? 1.0 : -1.0) * tiny());
            case 2:
                return base * unit();
            default:
                return std::abs(coordinate());
        }
    }

    std::mt19937_64 generator_;
    double reach_;
};

/// 1 or -1: the sign of the light's value; 0: either, for a point in its plane but for rounding.
double signOf(const glm::dvec3& place, const glm::dvec3& u, const glm::dvec3& v) {
    const glm::dvec3 normal = glm::cross(u, v);
    const double distance = -glm::dot(normal, place);
    const double reach = glm::length(place) + glm::length(u) + glm::length(v);
    if (std::abs(distance) <= 1e-12 * reach * glm::length(normal)) return 0.0;
    return std::copysign(1.0, distance);
}

/// Polygons that cross themselves have no side.
double signOf(const Polygon& polygon) {
    const Contour& contour = polygon.front();
    if (contour.size() != 4) return 0.0;
    const glm::dvec3 u = contour[1] - contour[0];
    const glm::dvec3 v = contour[3] - contour[0];
    if (polygon.size() != 1 || contour[2] != contour[0] + u + v) return 0.0;
    // Rounding of far vertices bends the light: 1e5 times farther than the rest of it is wide, and
    // by the 1e4 times that a smooth lobe magnifies, a millionth of its back may be seen.
    const double corner = glm::length(contour[0]);
    const double longest = std::max({corner, glm::length(u), glm::length(v)});
    const double height = glm::length(glm::cross(u, v)) / longest;
    if (!(std::min(corner, height) > 1e-5 * longest)) return 0.0;
    return signOf(contour[0], u, v);
}
double signOf(const EllipseShape& ellipse) {
    return signOf(ellipse.center, ellipse.halfAxisX, ellipse.halfAxisY);
}
double signOf(const SphereShape&) {
    return 1.0;
}
double signOf(const TubeShape&) {
    return 1.0;
}

/// How many cases a test has: POLYLUME_TRAP_CASES of the environment, or a hundred thousand.
int caseCount() {
    const char* text = std::getenv("POLYLUME_TRAP_CASES");
    return text != nullptr ? std::stoi(text) : 100'000;
}

/// By how much values may be over 1 in size, and on the wrong side of 0.
struct Rounding {
    double over;
    double wrongSide;
};

/// Whether a value is finite, from -1 to 1 and of the right sign, but for rounding.
template <typename Light>
bool isGood(const Light& light, double value, const Rounding& rounding) {
    // A point in a sphere or tube.
    if (value == -1.0) return true;
    // Comparisons with NaN are false.
    return std::abs(value) <= 1.0 + rounding.over && signOf(light) * value >= -rounding.wrongSide;
}

/// Sweeps lights that `draw` takes from a source; all values are good but for `rounding`.
template <typename Draw>
void sweep(unsigned seed, double reach, const Rounding& rounding, Draw draw) {
    TrapSource source(seed, reach);
    const Table& one = builtinTable(BuiltinTable::ggx);
    const Table& two = builtinTable(BuiltinTable::ggxTwoLobes);
    const int count = caseCount();
    int litCount = 0;
    for (int i = 0; i < count; ++i) {
        const auto light = draw(source);
        const double roughness = source.roughness();
        const TableEntry entry = (i % 2 == 0 ? one : two).lookup(roughness, source.cosThetaView());
        const double diffuse = formFactor(light);
        const double specular = lobeFormFactor(light, entry);
        ASSERT_TRUE(isGood(light, diffuse, rounding)) << diffuse << ", case " << i;
        ASSERT_TRUE(isGood(light, specular, rounding)) << specular << ", case " << i;
        litCount += specular != 0.0;
    }
    // The sweep has to see lights, too.
    EXPECT_GT(litCount, count / 5);
}

// Polygons are clamped to the range, so they only show what is not finite, and parallelograms what
// is on the wrong side.
constexpr Rounding kClamped{0.0, 1e-6};

TEST(TrapSweep, polygons) {
    sweep(20260101, 12.0, kClamped, [](TrapSource& source) { return source.light(); });
}

TEST(TrapSweep, parallelograms) {
    sweep(20260102, 12.0, kClamped, [](TrapSource& source) { return source.parallelogram(); });
}

// What the sums of round lights round by: a lobe as narrow as 1e-4 stretches arcs by its inverse.
constexpr Rounding kRounding{1e-9, 1e-9};

// Sizes and distances from a millimetre to a kilometre, and needles a millionth of that.
TEST(TrapSweep, ellipses) {
    sweep(20260103, 3.0, kRounding, [](TrapSource& source) { return source.ellipse(); });
}
TEST(TrapSweep, spheres) {
    sweep(20260104, 3.0, kRounding, [](TrapSource& source) { return source.sphere(); });
}
TEST(TrapSweep, tubes) {
    sweep(20260105, 3.0, kRounding, [](TrapSource& source) { return source.tube(); });
}

// Up to 1e24 times wider than their distance, or the other way round.
TEST(TrapSweep, extremeEllipses) {
    sweep(20260106, 12.0, kRounding, [](TrapSource& source) { return source.ellipse(); });
}
TEST(TrapSweep, extremeSpheres) {
    sweep(20260107, 12.0, kRounding, [](TrapSource& source) { return source.sphere(); });
}
TEST(TrapSweep, extremeTubes) {
    sweep(20260108, 12.0, kRounding, [](TrapSource& source) { return source.tube(); });
}

// The needle of 1e-12 by 78 that first showed that the half angles of a cone's near side need the
// digits: a light that is brighter than its whole lobe.
TEST(TrapSweep, needleThatAllButPassesThroughThePoint) {
    const EllipseShape needle{
        {-3.2931908425795591e-12, -1.0203003233407526e-13, 1.9116081024548393e-13},
        {-1e-12, 1e-12, -1e-12},
        {-1.432763365360028, -55.656057610322598, -54.223294244962567}};
    const Lobe lobe = builtinTable(BuiltinTable::ggx).lookup(0.0, 0.40404321356976897).lobes[0];
    EXPECT_NEAR(lobeFormFactor(needle, lobe), -1.0, 1e-6);
    EXPECT_GE(lobeFormFactor(needle, lobe), -1.0);
    // By the same ellipse, its axes renamed and turned: as exactly as sums of those tell.
    const double cosine = 0.6;
    const double sine = 0.8;
    const EllipseShape turned{needle.center, needle.halfAxisX * cosine + needle.halfAxisY * sine,
                              needle.halfAxisY * cosine - needle.halfAxisX * sine};
    const EllipseShape renamed{needle.center, needle.halfAxisY, -needle.halfAxisX};
    EXPECT_NEAR(lobeFormFactor(renamed, lobe), lobeFormFactor(needle, lobe), 1e-12);
    EXPECT_NEAR(formFactor(renamed), formFactor(needle), 1e-12);
    EXPECT_NEAR(formFactor(turned), formFactor(needle), 0.05);
}

TEST(TrapSweep, oppositeVerticesSeenHalfATurnApart) {
    // The point lies just off the line between two vertices: theta is nearly pi.
    for (const double distance : {1e-2, 1e-5, 1e-8, 1e-11}) {
        const Polygon light = {
            {{-1, 0, distance}, {1, 0, distance}, {1, -1, distance}, {-1, -1, distance}}};
        // Half of the ceiling is filled as the point nears it, by a rectangle to one side.
        EXPECT_NEAR(std::abs(formFactor(light)), 0.5, distance + 1e-12);
    }
}

}  // namespace
}  // namespace polylume::ltc::testing
