// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/planar_outline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>

namespace polylume::reference {
namespace {

using Contours = std::vector<PlanarContour>;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Shoelace formula over all contours: holes turn the other way.
double areaOf(const Contours& contours) {
    double sum = 0.0;
    for (const PlanarContour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            sum += 0.5 * cross(contour[i], contour[(i + 1) % contour.size()]);
        }
    }
    return sum;
}

/// Of a convex part.
bool covers(const PlanarContour& part, const glm::dvec2& p) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        if (cross(part[(i + 1) % part.size()] - part[i], p - part[i]) < 0.0) return false;
    }
    return true;
}

/// Turns left at every corner, but for rounding.
bool isConvex(const PlanarContour& part) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        const glm::dvec2 corner = part[(i + 1) % part.size()];
        if (cross(corner - part[i], part[(i + 2) % part.size()] - corner) < -1e-12) return false;
    }
    return part.size() >= 3;
}

double distanceToEdges(const Contours& contours, const glm::dvec2& p) {
    double least = INFINITY;
    for (const PlanarContour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2 from = contour[i];
            const glm::dvec2 along = contour[(i + 1) % contour.size()] - from;
            const double share =
                std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
            least = std::min(least, glm::length(p - from - share * along));
        }
    }
    return least;
}

/// Whether a point is within, by how often the contours turn around it: unlike the even-odd rule in
/// use.
bool isWound(const Contours& contours, const glm::dvec2& p) {
    double turn = 0.0;
    for (const PlanarContour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const glm::dvec2 a = contour[i] - p, b = contour[(i + 1) % contour.size()] - p;
            turn += std::atan2(cross(a, b), glm::dot(a, b));
        }
    }
    return turn > std::numbers::pi;
}

PlanarContour reversed(PlanarContour contour) {
    std::ranges::reverse(contour);
    return contour;
}

PlanarContour star(int points, double inner, double phase) {
    PlanarContour contour;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = phase + std::numbers::pi * i / points;
        const double radius = i % 2 == 0 ? 1.0 : inner;
        contour.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return contour;
}

PlanarContour square(double x, double y, double half) {
    return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

/// A contour around the origin with a random radius at each angle: concave, with no symmetry.
PlanarContour ragged(unsigned seed, int count) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> radius(0.3, 1.2);
    PlanarContour contour;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count, r = radius(generator);
        contour.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return contour;
}

std::map<std::string, Contours> shapes() {
    std::map<std::string, Contours> result = {
        {"triangle", {{{0, 0}, {1, 0.2}, {0.3, 0.9}}}},
        {"square", {square(0, 0, 1)}},
        {"L", {{{-1, -1}, {1.5, -1}, {1.5, 0.6}, {0.2, 0.6}, {0.2, 2}, {-1, 2}}}},
        {"star", {star(5, 0.4, 0.1)}},
        {"thin star", {star(9, 0.05, 0.0)}},
        {"pentagram", {star(7, 0.3, 0.5)}},
        {"frame", {square(0, 0, 1), reversed(square(0.1, 0.2, 0.5))}},
        {"three holes",
         {square(0, 0, 1), reversed(square(-0.5, -0.4, 0.2)), reversed(square(0.4, -0.4, 0.3)),
          reversed(star(5, 0.5, 0.3))}},
        // Starts on an edge, not at a corner.
        {"with a straight angle", {{{0, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}}},
        {"comb",
         {{{0, 0},
           {7, 0},
           {7, 2},
           {6, 2},
           {6, 1},
           {5, 1},
           {5, 2},
           {4, 2},
           {4, 1},
           {3, 1},
           {3, 3},
           {1, 1},
           {0, 2}}}},
    };
    // The hole in the star of "three holes" has to leave the others alone.
    for (glm::dvec2& p : result["three holes"][3]) p = 0.25 * p + glm::dvec2(0.0, 0.6);
    for (unsigned seed = 0; seed < 10; ++seed) {
        result["ragged " + std::to_string(seed)] = {ragged(seed, 23)};
    }
    return result;
}

class Scatter {
  public:
    glm::dvec2 operator()() {
        const double x = unit_(generator_);
        return {x, unit_(generator_)};
    }

  private:
    std::mt19937 generator_{42};
    std::uniform_real_distribution<double> unit_{-1.5, 2.5};
};

TEST(PlanarOutlineTest, partsAreConvexAndHaveTheAreaOfTheContours) {
    for (const auto& [name, contours] : shapes()) {
        const Contours parts = convexParts(contours);
        EXPECT_NEAR(areaOf(parts), areaOf(contours), 1e-12) << name;
        for (const PlanarContour& part : parts) {
            EXPECT_GT(areaOf(Contours{part}), 0.0) << name;
            EXPECT_NEAR(area(part), areaOf(Contours{part}), 1e-14) << name;
            EXPECT_TRUE(isConvex(part)) << name;
        }
    }
    EXPECT_EQ(convexParts(shapes()["square"]).size(), 1u);
    EXPECT_FALSE(isConvex(shapes()["star"][0]));
}

TEST(PlanarOutlineTest, everyPointWithinIsInOnePart) {
    for (const auto& [name, contours] : shapes()) {
        const Contours parts = convexParts(contours);
        Scatter scatter;
        int within = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec2 p = scatter();
            if (distanceToEdges(contours, p) < 1e-9) continue;
            const bool isWithin = isWound(contours, p);
            const auto count = std::ranges::count_if(
                parts, [&](const PlanarContour& part) { return covers(part, p); });
            // No scattered point falls on the border between two parts.
            ASSERT_EQ(count, isWithin ? 1 : 0) << name;
            ASSERT_EQ(isInside(contours, p), isWithin) << name;
            within += isWithin ? 1 : 0;
        }
        EXPECT_GT(within, 30) << name;
    }
}

TEST(PlanarOutlineTest, theTurnOfTheContoursIsAllOne) {
    const Contours frame = shapes()["frame"];
    const Contours other = {reversed(frame[0]), frame[1]};
    EXPECT_NEAR(areaOf(convexParts(other)), areaOf(frame), 1e-12);
}

TEST(PlanarOutlineTest, contoursWithoutAreaGiveNoAreaEither) {
    EXPECT_EQ(areaOf(convexParts({{{0, 0}, {1, 1}, {2, 2}}})), 0.0);
    EXPECT_EQ(areaOf(convexParts({{{0, 0}, {1, 0}, {2, 0}, {1, 0}}})), 0.0);
    EXPECT_EQ(areaOf(convexParts({{{1, 1}, {1, 1}, {1, 1}}})), 0.0);
    // Doubled vertices take nothing away.
    EXPECT_NEAR(areaOf(convexParts({{{0, 0}, {0, 0}, {1, 0}, {1, 0}, {0, 1}}})), 0.5, 1e-15);
}

}  // namespace
}  // namespace polylume::reference
