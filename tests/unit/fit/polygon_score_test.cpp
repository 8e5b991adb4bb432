// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/polygon_score.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ltc/polygon_integral.hpp"

namespace polylume::fit {
namespace {

double cosineShare(const Rectangle& rectangle) {
    const ltc::Contour contour(rectangle.begin(), rectangle.end());
    return ltc::formFactor({&contour, 1});
}

TEST(PolygonScore, rectanglesAreTheSameForTheSameSeed) {
    const std::vector<Rectangle> first = randomRectangles(7, 20);
    EXPECT_EQ(first, randomRectangles(7, 20));
    EXPECT_NE(first, randomRectangles(8, 20));
    // The same on every machine: mt19937_64's first number of this seed gives the first height.
    std::vector<Rectangle> fewer = randomRectangles(7, 5);
    EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), first.begin()));
}

TEST(PolygonScore, rectanglesAreNearFarAndAcrossTheHorizon) {
    int acrossCount = 0;
    int nearCount = 0;
    int farCount = 0;
    for (const Rectangle& r : randomRectangles(3, 2000)) {
        const glm::dvec3 x = r[3] - r[0];
        const glm::dvec3 y = r[1] - r[0];
        EXPECT_NEAR(glm::dot(x, y), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(0.5 * (r[0] + r[2])), 1.0, 1e-12);
        EXPECT_GE(0.5 * (r[0].z + r[2].z), -0.2);
        // The point sees the front.
        EXPECT_GE(cosineShare(r), 0.0);
        const auto [low, high] = std::minmax({r[0].z, r[1].z, r[2].z, r[3].z});
        acrossCount += low < 0.0 && high > 0.0 ? 1 : 0;
        const double longest = std::max(glm::length(x), glm::length(y));
        EXPECT_TRUE(longest >= 0.1 && longest <= 6.0);
        nearCount += longest > 2.0 ? 1 : 0;
        farCount += longest < 0.4 ? 1 : 0;
    }
    EXPECT_GT(acrossCount, 500);
    EXPECT_GT(nearCount, 500);
    EXPECT_GT(farCount, 200);
}

/// The direction's ray meets the rectangle, by its plane.
bool isHit(const Rectangle& r, const glm::dvec3& direction) {
    const glm::dvec3 x = r[3] - r[0];
    const glm::dvec3 y = r[1] - r[0];
    const glm::dvec3 normal = glm::cross(x, y);
    const double distance = glm::dot(r[0], normal) / glm::dot(direction, normal);
    if (!(distance > 0.0)) return false;
    const glm::dvec3 local = direction * distance - r[0];
    const double u = glm::dot(local, x) / glm::dot(x, x);
    const double v = glm::dot(local, y) / glm::dot(y, y);
    return u >= 0.0 && u <= 1.0 && v >= 0.0 && v <= 1.0;
}

TEST(PolygonScore, conesHoldWhatRaysHit) {
    int hitCount = 0;
    for (const Rectangle& rectangle : randomRectangles(11, 100)) {
        const RectangleCone cone(rectangle);
        for (int i = 0; i < 500; ++i) {
            // A spiral over the sphere.
            const double z = (i + 0.5) / 250.0 - 1.0;
            const double planar = std::sqrt(1.0 - z * z);
            const glm::dvec3 direction(planar * std::cos(2.4 * i), planar * std::sin(2.4 * i), z);
            EXPECT_EQ(cone.holds(direction), isHit(rectangle, direction));
            hitCount += cone.holds(direction) ? 1 : 0;
        }
    }
    EXPECT_GT(hitCount, 1000);
}

TEST(PolygonScore, theIdentityLobeCatchesTheFormFactor) {
    for (const Rectangle& rectangle : randomRectangles(5, 50)) {
        EXPECT_NEAR(modelShare(rectangle, ltc::TableEntry()), cosineShare(rectangle), 1e-12);
    }
}

TEST(PolygonScore, countsRectanglesThatCatchEnough) {
    PolygonErrors errors;
    errors.add(0.5, -0.05);
    errors.add(0.02, 0.01);
    errors.add(0.0099, 1.0);  // Too little.
    errors.add(std::nan(""), 1.0);
    EXPECT_EQ(errors.count, 2);
    EXPECT_DOUBLE_EQ(errors.mean(), 0.5 * (0.1 + 0.5));
    EXPECT_DOUBLE_EQ(errors.ratioOfSums(), 0.06 / 0.52);
    PolygonErrors sum;
    EXPECT_EQ(sum.mean(), 0.0);
    sum.add(errors);
    sum.add(errors);
    EXPECT_EQ(sum.count, 4);
    EXPECT_DOUBLE_EQ(sum.mean(), errors.mean());
}

}  // namespace
}  // namespace polylume::fit
