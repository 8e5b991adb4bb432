// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/spherical_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lights/plane_axes.hpp"

namespace polylume::reference {
namespace {

constexpr double kPi = std::numbers::pi;
using Triangle = std::array<glm::dvec3, 3>;

class Random {
  public:
    explicit Random(unsigned seed) : generator_(seed) {}
    double operator()(double low = 0.0, double high = 1.0) {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    glm::dvec3 vector() {
        const double x = (*this)(-1, 1), y = (*this)(-1, 1);
        return {x, y, (*this)(-1, 1)};
    }

  private:
    std::mt19937_64 generator_;
};

double angle(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// L'Huilier's theorem: from the sides alone, unlike the formula in use.
double solidAngleBySides(const Triangle& t) {
    const double a = angle(t[1], t[2]), b = angle(t[2], t[0]), c = angle(t[0], t[1]);
    const double s = 0.5 * (a + b + c);
    const double product =
        std::tan(s / 2) * std::tan((s - a) / 2) * std::tan((s - b) / 2) * std::tan((s - c) / 2);
    return 4.0 * std::atan(std::sqrt(std::max(product, 0.0)));
}

/// The rectangle +-a by +-b at distance h, seen from its axis (Khadjavi 1968).
double solidAngleOnAxis(double a, double b, double h) {
    return 4.0 * std::asin(a * b / std::sqrt((a * a + h * h) * (b * b + h * h)));
}

/// Parts of a planar shape and how often each was hit.
struct Partition {
    std::vector<double> solidAngles;
    std::vector<double> hits;

    explicit Partition(std::size_t count) : solidAngles(count), hits(count) {}

    /// In standard deviations of the chi-square distribution above its mean.
    double excess() const {
        double total = 0.0, count = 0.0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            total += solidAngles[i];
            count += hits[i];
        }
        double sum = 0.0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const double expected = count * solidAngles[i] / total;
            sum += (hits[i] - expected) * (hits[i] - expected) / expected;
        }
        const double freedom = static_cast<double>(hits.size()) - 1.0;
        return (sum - freedom) / std::sqrt(2.0 * freedom);
    }
};

/// 15 degrees of freedom: one in 10^5 is above 5.5 deviations.
constexpr double kMostExcess = 5.5;
constexpr int kSide = 4;
constexpr int kSampleCount = 8000;

/// Point (i, j) of a triangular grid of kSide steps.
glm::dvec3 gridPoint(const Triangle& t, int i, int j) {
    const double u = static_cast<double>(i) / kSide, v = static_cast<double>(j) / kSide;
    return (1.0 - u - v) * t[0] + u * t[1] + v * t[2];
}

/// Weights of the vertices where `direction` meets the triangle's plane.
glm::dvec3 weightsOf(const Triangle& t, const glm::dvec3& direction) {
    const glm::dvec3 weights = glm::inverse(glm::dmat3(t[0], t[1], t[2])) * direction;
    return weights / (weights.x + weights.y + weights.z);
}

template <typename Sample>
Partition sampledTriangle(const Triangle& t, Random& random, const Sample& sample) {
    // Cells of the grid in rows: the upright triangles and those upside down.
    Partition parts(kSide * kSide);
    const auto cellOf = [](int i, int j, int upside) {
        return static_cast<std::size_t>(j * (2 * kSide - j) + 2 * i + upside);
    };
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i + j < kSide; ++i) {
            parts.solidAngles[cellOf(i, j, 0)] = solidAngleBySides(
                {gridPoint(t, i, j), gridPoint(t, i + 1, j), gridPoint(t, i, j + 1)});
            if (i + j + 1 == kSide) continue;
            parts.solidAngles[cellOf(i, j, 1)] = solidAngleBySides(
                {gridPoint(t, i + 1, j), gridPoint(t, i + 1, j + 1), gridPoint(t, i, j + 1)});
        }
    }
    for (int n = 0; n < kSampleCount; ++n) {
        const double u = random(), v = random();
        const glm::dvec3 w = weightsOf(t, sample(glm::dvec2(u, v)));
        EXPECT_GT(std::min({w.x, w.y, w.z}), -1e-6);
        const int i = std::clamp(static_cast<int>(kSide * w.y), 0, kSide - 1);
        const int j = std::clamp(static_cast<int>(kSide * w.z), 0, kSide - 1 - i);
        const bool upside = kSide * (w.y + w.z) - i - j > 1.0 && i + j + 1 < kSide;
        parts.hits[cellOf(i, j, upside ? 1 : 0)] += 1.0;
    }
    return parts;
}

TEST(SphericalTriangleTest, solidAnglesAreThoseOfClosedForms) {
    EXPECT_NEAR(SphericalTriangle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}).solidAngle(), kPi / 2, 1e-14);
    EXPECT_NEAR(triangleSolidAngle({1, 0, 0}, {0, 0, 3}, {0, 2, 0}), kPi / 2, 1e-14);
    // Nearly a half sphere.
    const double h = 1e-6;
    EXPECT_NEAR(SphericalTriangle({2, 0, h}, {-1, 2, h}, {-1, -2, h}).solidAngle(), 2 * kPi, 1e-5);
    // Small and far: area cos / d^2.
    const glm::dvec3 center(30, -40, 20);
    const glm::dvec3 u(0.1, 0.02, 0), v(0.01, 0.1, 0.05);
    const double area = 0.5 * glm::dot(glm::cross(u, v), glm::normalize(center));
    const double far = triangleSolidAngle(center, center + u, center + v);
    const glm::dvec3 middle = center + (u + v) / 3.0;
    EXPECT_NEAR(far, std::abs(area) / glm::dot(center, center),
                0.01 * far);  // Seen from where its corner is.
    const double exact =
        0.5 * std::abs(glm::dot(glm::cross(u, v), middle)) / std::pow(glm::length(middle), 3.0);
    EXPECT_NEAR(far, exact, 1e-5 * exact);  // (Size / distance)^2.
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const Triangle t = {random.vector(), random.vector(), random.vector()};
        const double found = SphericalTriangle(t[0], t[1], t[2]).solidAngle();
        EXPECT_NEAR(found, solidAngleBySides(t), 1e-7);
    }
}

TEST(SphericalTriangleTest, samplesAreEvenByTheSolidAngle) {
    Random random(2);
    int tested = 0;
    for (int n = 0; tested < 25; ++n) {
        const Triangle t = {random.vector(), random.vector(), random.vector()};
        const SphericalTriangle triangle(t[0], t[1], t[2]);
        if (triangle.solidAngle() < 0.01) continue;
        ++tested;
        const auto sample = [&](const glm::dvec2& r) {
            const glm::dvec3 direction = triangle.sample(r);
            EXPECT_NEAR(glm::length(direction), 1.0, 1e-9);
            return direction;
        };
        EXPECT_LT(sampledTriangle(t, random, sample).excess(), kMostExcess) << "triangle " << n;
    }
}

TEST(SphericalTriangleTest, theCheckFindsSamplesThatAreEvenByArea) {
    Random random(3);
    const Triangle t = {glm::dvec3(-1, -1, 0.5), {2, -1, 0.7}, {-1, 3, 0.6}};
    const auto byArea = [&](const glm::dvec2& r) {
        const double root = std::sqrt(r.x);
        return (1.0 - root) * t[0] + root * (1.0 - r.y) * t[1] + root * r.y * t[2];
    };
    EXPECT_GT(sampledTriangle(t, random, byArea).excess(), 10.0 * kMostExcess);
}

/// corner + s x + t y.
struct Rectangle {
    glm::dvec3 corner, x, y;

    double solidAngle(double s0, double s1, double t0, double t1) const {
        const auto at = [&](double s, double t) { return corner + s * x + t * y; };
        return solidAngleBySides({at(s0, t0), at(s1, t0), at(s1, t1)}) +
               solidAngleBySides({at(s0, t0), at(s1, t1), at(s0, t1)});
    }
};

template <typename Sample>
Partition sampledRectangle(const Rectangle& r, Random& random, const Sample& sample) {
    Partition parts(kSide * kSide);
    const auto cellOf = [](int i, int j) { return static_cast<std::size_t>(j * kSide + i); };
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            const double s = 1.0 / kSide;
            parts.solidAngles[cellOf(i, j)] = r.solidAngle(i * s, (i + 1) * s, j * s, (j + 1) * s);
        }
    }
    const glm::dvec3 normal = glm::normalize(glm::cross(r.x, r.y));
    for (int n = 0; n < kSampleCount; ++n) {
        const double u = random(), v = random();
        const glm::dvec3 offset = sample(glm::dvec2(u, v)) - r.corner;
        const double s = glm::dot(offset, r.x) / glm::dot(r.x, r.x);
        const double t = glm::dot(offset, r.y) / glm::dot(r.y, r.y);
        EXPECT_NEAR(glm::dot(offset, normal), 0.0, 1e-9);
        EXPECT_TRUE(std::min(s, t) > -1e-9 && std::max(s, t) < 1.0 + 1e-9) << s << " " << t;
        const int i = std::clamp(static_cast<int>(kSide * s), 0, kSide - 1);
        const int j = std::clamp(static_cast<int>(kSide * t), 0, kSide - 1);
        parts.hits[cellOf(i, j)] += 1.0;
    }
    return parts;
}

Rectangle randomRectangle(Random& random) {
    const glm::dvec3 normal = glm::normalize(random.vector());
    const glm::dvec3 x = glm::normalize(glm::cross(normal, random.vector()));
    return {random.vector(), random(0.1, 2.0) * x, random(0.1, 2.0) * glm::cross(normal, x)};
}

TEST(SphericalRectangleTest, solidAnglesAreThoseOfClosedForms) {
    for (const glm::dvec3 size :
         {glm::dvec3(1, 1, 1), {0.3, 2, 0.5}, {0.01, 0.02, 1}, {1e3, 1e3, 1}, {1, 1, 1e-4}}) {
        const SphericalRectangle rectangle({-size.x, -size.y, size.z}, {2 * size.x, 0, 0},
                                           {0, 2 * size.y, 0});
        const double expected = solidAngleOnAxis(size.x, size.y, size.z);
        // Four arc cosines of nearly -1 lose digits: 1e-12 each where 5e-9 are left to -1.
        EXPECT_NEAR(rectangle.solidAngle(), expected, 1e-11);
    }
    Random random(4);
    for (int i = 0; i < 2000; ++i) {
        const Rectangle r = randomRectangle(random);
        const double expected = r.solidAngle(0, 1, 0, 1);
        EXPECT_NEAR(SphericalRectangle(r.corner, r.x, r.y).solidAngle(), expected, 2e-7);
        EXPECT_NEAR(SphericalRectangle(r.corner, r.y, r.x).solidAngle(), expected, 2e-7);
    }
}

TEST(SphericalRectangleTest, samplesAreEvenByTheSolidAngle) {
    Random random(5);
    int tested = 0;
    for (int n = 0; tested < 25; ++n) {
        const Rectangle r = randomRectangle(random);
        const SphericalRectangle rectangle(r.corner, r.x, r.y);
        if (rectangle.solidAngle() < 0.01) continue;
        ++tested;
        const auto sample = [&](const glm::dvec2& u) { return rectangle.sample(u); };
        EXPECT_LT(sampledRectangle(r, random, sample).excess(), kMostExcess) << "rectangle " << n;
    }
}

TEST(SphericalRectangleTest, theCheckFindsSamplesThatAreEvenByArea) {
    Random random(6);
    const Rectangle r{{-1, -1, 0.5}, {3, 0, 0}, {0, 2, 0}};
    const auto byArea = [&](const glm::dvec2& u) { return r.corner + u.x * r.x + u.y * r.y; };
    EXPECT_GT(sampledRectangle(r, random, byArea).excess(), 10.0 * kMostExcess);
}

/// The integral of the direction over a shape, by stratified samples.
template <typename Shape>
glm::dvec3 directionSum(const Shape& shape) {
    Random random(5);
    constexpr int kSteps = 300;
    glm::dvec3 sum(0.0);
    for (int j = 0; j < kSteps; ++j) {
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec3 direction =
                shape.sample({(i + random()) / kSteps, (j + random()) / kSteps});
            EXPECT_NEAR(glm::length(direction), 1.0, 1e-12);
            sum += direction;
        }
    }
    return shape.solidAngle() / (kSteps * kSteps) * sum;
}

TEST(SphericalCapTest, isEvenAndAsLargeAsItIs) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, 0.5));
    for (const double half : {1e-9, 1e-4, 0.1, 1.0, 0.5 * kPi}) {
        const double sine = std::sin(half);
        const SphericalCap cap(axis, sine, std::cos(half));
        const double haversine = std::sin(0.5 * half);
        EXPECT_NEAR(cap.solidAngle() / (4.0 * kPi * haversine * haversine), 1.0, 1e-12);
        // Lambert: the sum is that of its disk's area.
        const glm::dvec3 expected = kPi * sine * sine * axis;
        EXPECT_LT(glm::length(directionSum(cap) - expected), 1e-4 * glm::length(expected));
        Random random(6);
        for (int i = 0; i < 1000; ++i) {
            EXPECT_LT(angle(cap.sample({random(), random()}), axis), half * (1.0 + 1e-6) + 1e-15);
        }
    }
}

TEST(SphericalBandTest, isEvenAndAsLargeAsItIs) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(1, -2, 0.5));
    const glm::dvec3 y = perpendicularTo(x);
    const glm::dmat3 axes(x, y, glm::cross(x, y));
    EXPECT_NEAR(glm::determinant(axes), 1.0, 1e-12);
    for (const double half : {1e-9, 0.01, 0.7, 0.5 * kPi}) {
        const double first = -0.3, last = 1.9, sine = std::sin(half);
        const SphericalBand band(axes, first, last, sine);
        EXPECT_NEAR(band.solidAngle(), 2.0 * sine * (last - first), 1e-12);
        // The integrals of cos b over sin b, and of cos a and sin a.
        const double across = half + sine * std::cos(half);
        const glm::dvec3 expected = across * ((std::sin(last) - std::sin(first)) * x +
                                              (std::cos(first) - std::cos(last)) * y);
        EXPECT_LT(glm::length(directionSum(band) - expected), 1e-4 * glm::length(expected));
        Random random(6);
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 direction = band.sample({random(), random()});
            EXPECT_LE(std::abs(glm::dot(direction, axes[2])), sine * (1.0 + 1e-6) + 1e-15);
            const double turn = std::atan2(glm::dot(direction, y), glm::dot(direction, x));
            EXPECT_TRUE(turn > first - 1e-9 && turn < last + 1e-9);
        }
    }
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

TEST(SphericalShapesTest, nearlyDegenerateOnesStayFinite) {
    const std::vector<Triangle> triangles = {
        {glm::dvec3(1, 0, 0), {1, 0, 0}, {0, 0, 1}},          // Two vertices in one.
        {glm::dvec3(1, 0, 0), {1, 1, 0}, {0, 1, 0}},          // The origin in its plane.
        {glm::dvec3(1, 0, 0), {1, 1e-12, 0}, {1, 0, 1e-12}},  // Tiny.
        {glm::dvec3(1, 0, 0), {-1, 1e-9, 0}, {0, 0, 1}},      // A side of half a turn.
        {glm::dvec3(1, -5, 1e-9), {1, 5, 1e-9}, {-3, 0, 1e-9}},
        {glm::dvec3(1e12, 0, 1), {0, 1e12, 1}, {-1e12, -1e12, 1}},
    };
    for (const Triangle& t : triangles) {
        const SphericalTriangle triangle(t[0], t[1], t[2]);
        EXPECT_TRUE(triangle.solidAngle() >= 0.0 && triangle.solidAngle() < 6.2832);
        if (!(triangle.solidAngle() > 0.0)) continue;
        for (const double x : {0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0}) {
            for (const double y : {0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0}) {
                const glm::dvec3 direction = triangle.sample({x, y});
                EXPECT_TRUE(isFinite(direction));
                EXPECT_NEAR(glm::length(direction), 1.0, 1e-6);
            }
        }
    }
    const std::vector<Rectangle> rectangles = {
        {{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}},      // Around the origin.
        {{1, 1, 0}, {2, 0, 0}, {0, 2, 0}},        // The origin in its plane.
        {{-1, -1, 1e-12}, {2, 0, 0}, {0, 2, 0}},  // Just above.
        {{0, 0, 1e-300}, {2, 0, 0}, {0, 2, 0}},   // At a corner.
        {{-1, 3, 1}, {2, 0, 0}, {0, 1e-14, 0}},   // A needle.
        {{-1e9, -1e9, 1}, {2e9, 0, 0}, {0, 2e9, 0}}, {{1e6, 1e6, 1e6}, {1, 0, 0}, {0, 1, 0}},
    };
    for (const Rectangle& r : rectangles) {
        const SphericalRectangle rectangle(r.corner, r.x, r.y);
        EXPECT_TRUE(rectangle.solidAngle() >= 0.0 && rectangle.solidAngle() < 6.2832);
        if (!(rectangle.solidAngle() > 0.0)) continue;
        for (const double x : {0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0}) {
            for (const double y : {0.0, 1e-9, 0.5, 1.0 - 1e-12, 1.0}) {
                EXPECT_TRUE(isFinite(rectangle.sample({x, y})))
                    << r.corner.x << ", " << r.corner.z << " at " << x << ", " << y;
            }
        }
    }
}

}  // namespace
}  // namespace polylume::reference
