// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/scrambled_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace polylume::reference {
namespace {

using Points = std::vector<glm::dvec2>;

Points pointsOf(std::uint64_t seed, std::uint32_t first, std::uint32_t count) {
    const ScrambledPoints source(seed);
    Points points;
    for (std::uint32_t i = first; i < first + count; ++i) points.push_back(source.point(i));
    return points;
}

Points randomPoints(std::uint64_t seed, std::uint32_t count) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> unit;
    Points points;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double x = unit(generator);
        points.emplace_back(x, unit(generator));
    }
    return points;
}

/// Whether every elementary interval of area 1 / size() holds one point; of a power of two.
bool isNet(const Points& points) {
    const std::size_t count = points.size();
    for (std::size_t columns = 1; columns <= count; columns *= 2) {
        const std::size_t rows = count / columns;
        std::vector<bool> taken(count, false);
        for (const glm::dvec2& p : points) {
            const auto x = static_cast<std::size_t>(p.x * static_cast<double>(columns));
            const auto y = static_cast<std::size_t>(p.y * static_cast<double>(rows));
            if (x >= columns || y >= rows || taken[y * columns + x]) return false;
            taken[y * columns + x] = true;
        }
    }
    return true;
}

/// Of how unevenly `values` in [0, 1) fall into as many bins.
double chiSquare(const std::vector<double>& values, std::size_t binCount) {
    std::vector<double> counts(binCount, 0.0);
    for (const double v : values) counts[static_cast<std::size_t>(v * binCount)] += 1.0;
    const double expected = static_cast<double>(values.size()) / static_cast<double>(binCount);
    double sum = 0.0;
    for (const double n : counts) sum += (n - expected) * (n - expected) / expected;
    return sum;
}

TEST(ScrambledPointsTest, fillEveryElementaryInterval) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        for (std::uint32_t m = 0; m <= 10; ++m) {
            EXPECT_TRUE(isNet(pointsOf(seed, 0, 1u << m))) << "seed " << seed << ", 2^" << m;
        }
        // So does every aligned block further on.
        EXPECT_TRUE(isNet(pointsOf(seed, 3u << 6, 1u << 6)));
        EXPECT_TRUE(isNet(pointsOf(seed, 0xffffff00u, 1u << 7)));
    }
}

TEST(ScrambledPointsTest, theCheckFindsPointsThatDoNot) {
    EXPECT_FALSE(isNet(randomPoints(1, 64)));
    EXPECT_FALSE(isNet(pointsOf(1, 1, 64)));  // Not aligned.
    Points points = pointsOf(1, 0, 64);
    std::swap(points[5].x, points[20].x);
    EXPECT_FALSE(isNet(points));
}

TEST(ScrambledPointsTest, oneIndexIsEvenOverSeeds) {
    constexpr std::size_t kSeedCount = 8192;
    for (const std::uint32_t index : {0u, 1u, 2u, 7u, 100u, 4096u}) {
        std::vector<double> x, y, both;
        for (std::uint64_t seed = 0; seed < kSeedCount; ++seed) {
            const glm::dvec2 p = ScrambledPoints(hash(seed, 17)).point(index);
            x.push_back(p.x);
            y.push_back(p.y);
            both.push_back((std::floor(8.0 * p.x) + p.y) / 8.0);
        }
        // One in 10^4 with 63 degrees of freedom is above 113; 18 values are tested.
        EXPECT_LT(chiSquare(x, 64), 113.0) << index;
        EXPECT_LT(chiSquare(y, 64), 113.0) << index;
        EXPECT_LT(chiSquare(both, 64), 113.0) << index;
        std::vector<double> biased = x;
        for (double& v : biased) v = std::pow(v, 1.1);
        EXPECT_GT(chiSquare(biased, 64), 113.0);
    }
}

/// Pearson's correlation of one coordinate at equal indices.
double correlation(const Points& a, const Points& b) {
    const double count = static_cast<double>(a.size());
    double sum = 0.0;
    // The mean is 1/2 and the variance 1/12 for all sets in question.
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i].x - 0.5) * (b[i].x - 0.5);
    return 12.0 * sum / count;
}

TEST(ScrambledPointsTest, seedsAreIndependentOfEachOther) {
    constexpr std::uint32_t kCount = 256;
    constexpr int kPairCount = 1000;
    double sum = 0.0, squares = 0.0;
    for (int pair = 0; pair < kPairCount; ++pair) {
        const Points a = pointsOf(static_cast<std::uint64_t>(pair), 0, kCount);
        const Points b = pointsOf(static_cast<std::uint64_t>(pair) + 1, 0, kCount);
        const double r = correlation(a, b);
        sum += r;
        squares += r * r;
    }
    // Of independent random points: deviation 1 / sqrt(count) each, so four of the mean. Two nets
    // have half as many free first digits, and a little less of the others.
    EXPECT_LT(std::abs(sum / kPairCount),
              4.0 / std::sqrt(static_cast<double>(kPairCount) * kCount));
    EXPECT_LT(squares / kPairCount * kCount, 2.0);
    // The twin: a set and itself.
    EXPECT_GT(correlation(pointsOf(3, 0, kCount), pointsOf(3, 0, kCount)), 0.9);
}

TEST(ScrambledPointsTest, coordinatesAreIndependentOfEachOther) {
    double sum = 0.0;
    constexpr int kSeedCount = 4000;
    for (std::uint64_t seed = 0; seed < kSeedCount; ++seed) {
        const glm::dvec2 p = ScrambledPoints(seed).point(5);
        sum += 12.0 * (p.x - 0.5) * (p.y - 0.5);
    }
    EXPECT_LT(std::abs(sum / kSeedCount), 4.0 / std::sqrt(static_cast<double>(kSeedCount)));
}

/// Root mean square error over seeds of the mean of a smooth function.
double integrationError(std::uint32_t count,
                        const std::function<Points(std::uint64_t, std::uint32_t)>& points) {
    const double exact = (std::numbers::e - 1.0) * 2.0 / std::numbers::pi;
    double squares = 0.0;
    constexpr int kSeedCount = 64;
    for (std::uint64_t seed = 0; seed < kSeedCount; ++seed) {
        double sum = 0.0;
        for (const glm::dvec2& p : points(seed, count)) {
            sum += std::exp(p.x) * std::sin(std::numbers::pi * p.y);
        }
        const double error = sum / count - exact;
        squares += error * error;
    }
    return std::sqrt(squares / kSeedCount);
}

TEST(ScrambledPointsTest, integrateSmoothFunctionsFasterThanByTheRoot) {
    const auto scrambled = [](std::uint64_t seed, std::uint32_t count) {
        return pointsOf(seed, 0, count);
    };
    // Owen 1997: n^-1.5 up to logarithms; by the root it would be n^-0.5.
    const double ratio = integrationError(1024, scrambled) / integrationError(16, scrambled);
    EXPECT_LT(ratio, std::pow(64.0, -1.2));
    EXPECT_GT(integrationError(1024, randomPoints) / integrationError(16, randomPoints),
              std::pow(64.0, -0.7));
    RecordProperty("order", std::to_string(-std::log(ratio) / std::log(64.0)));
}

}  // namespace
}  // namespace polylume::reference
