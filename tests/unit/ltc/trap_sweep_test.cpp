// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ltc/builtin_table.hpp"
#include "ltc/polygon_integral.hpp"
#include "unit/ltc/polygons.hpp"

namespace polylume::ltc::testing {
namespace {

/// Draws lights and views that are, more often than not, special: coordinates of 0, 1 and of many
/// magnitudes, repeated vertices, points in the light's plane, lights on the horizon.
class TrapSource {
  public:
    explicit TrapSource(unsigned seed) : generator_(seed) {}

    double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(generator_); }

    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }

    double coordinate() {
        static constexpr double kSpecial[] = {0.0,   -0.0,   1.0,   -1.0,   0.5, -0.5,
                                              1e-30, -1e-30, 1e-12, -1e-12, 1e6, -1e6};
        switch (below(4)) {
            case 0:
                return kSpecial[below(std::size(kSpecial))];
            case 1:
                return below(5) - 2.0;
            case 2:
                return std::pow(10.0, 24.0 * unit() - 12.0) * (below(2) ? 1.0 : -1.0);
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

    double cosThetaView() {
        static constexpr double kSpecial[] = {0.0, 1.0, 1e-4, -0.5, 1e-30, 0.5, 1.0 - 1e-16};
        return below(2) ? kSpecial[below(std::size(kSpecial))] : unit();
    }

    double roughness() {
        static constexpr double kSpecial[] = {0.0, 1.0, 1e-9, 0.05, 1.0 / 63.0, 0.5};
        return below(2) ? kSpecial[below(std::size(kSpecial))] : unit();
    }

  private:
    std::mt19937_64 generator_;
};

TEST(TrapSweep, aMillionConfigurationsGiveFiniteValues) {
    TrapSource source(20260101);
    const Table& one = builtinTable(BuiltinTable::ggx);
    const Table& two = builtinTable(BuiltinTable::ggxTwoLobes);
    int nonZeroCount = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Polygon light = source.light();
        const double roughness = source.roughness();
        const TableEntry entry = (i % 2 == 0 ? one : two).lookup(roughness, source.cosThetaView());
        const double diffuse = formFactor(light);
        const double specular = lobeFormFactor(light, entry);
        // A comparison with NaN is false.
        ASSERT_TRUE(diffuse >= -1.0 && diffuse <= 1.0) << "configuration " << i;
        ASSERT_TRUE(specular >= -1.0 && specular <= 1.0) << "configuration " << i;
        nonZeroCount += specular != 0.0;
    }
    // The sweep has to see lights, too.
    EXPECT_GT(nonZeroCount, 200'000);
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
