// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/polygon_score.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "ltc/polygon_integral.hpp"

namespace polylume::fit {
namespace {

/// Numbers in [0, 1) that are the same with every standard library.
class UniformRandom {
  public:
    explicit UniformRandom(std::uint64_t seed) : generator_(seed) {}

    double operator()() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * (*this)(); }

  private:
    std::mt19937_64 generator_;
};

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A unit direction at a cosine from z, turned by `turn` of a full turn.
glm::dvec3 around(double cosine, double turn) {
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {sine * std::cos(kTurn * turn), sine * std::sin(kTurn * turn), cosine};
}

/// Two directions that make a right-handed frame with the unit `axis`.
std::array<glm::dvec3, 2> frameOf(const glm::dvec3& axis) {
    const glm::dvec3 other = std::abs(axis.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 first = glm::normalize(glm::cross(other, axis));
    return {first, glm::cross(axis, first)};
}

Rectangle randomRectangle(const glm::dvec3& middle, UniformRandom& random) {
    constexpr double kLeastHalfSide = 0.05;
    constexpr double kMostHalfSide = 3.0;
    constexpr double kLeastFrontCosine = 0.2;
    const auto [first, second] = frameOf(middle);
    const double frontCosine = random.between(kLeastFrontCosine, 1.0);
    const glm::dvec3 local = around(frontCosine, random());
    const glm::dvec3 away = local.x * first + local.y * second + local.z * middle;
    const auto [u, v] = frameOf(away);
    const double turn = kTurn * random();
    const auto halfSide = [&] {
        return kLeastHalfSide * std::pow(kMostHalfSide / kLeastHalfSide, random());
    };
    const glm::dvec3 x = (std::cos(turn) * u + std::sin(turn) * v) * halfSide();
    const glm::dvec3 y = (std::cos(turn) * v - std::sin(turn) * u) * halfSide();
    // With `away` pointing from the viewer, x to y is clockwise for him.
    return {middle - x - y, middle - x + y, middle + x + y, middle + x - y};
}

}  // namespace

std::vector<Rectangle> randomRectangles(std::uint64_t seed, int count) {
    constexpr double kLeastHeight = -0.2;
    UniformRandom random(seed);
    std::vector<Rectangle> rectangles;
    for (int i = 0; i < count; ++i) {
        const double height = random.between(kLeastHeight, 1.0);
        rectangles.push_back(randomRectangle(around(height, random()), random));
    }
    return rectangles;
}

RectangleCone::RectangleCone(const Rectangle& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        sides_[i] = glm::cross(corners[i], corners[(i + 1) % corners.size()]);
    }
    // Inside is where the middle is.
    const glm::dvec3 middle = corners[0] + corners[2];
    for (glm::dvec3& side : sides_) {
        if (glm::dot(side, middle) < 0.0) side = -side;
    }
}

void PolygonErrors::add(double truth, double error) {
    if (!(truth >= kLeastCaughtShare)) return;
    relativeSum += std::abs(error) / truth;
    errorSum += std::abs(error);
    truthSum += truth;
    ++count;
}

void PolygonErrors::add(const PolygonErrors& other) {
    relativeSum += other.relativeSum;
    errorSum += other.errorSum;
    truthSum += other.truthSum;
    count += other.count;
}

double modelShare(const Rectangle& rectangle, const ltc::TableEntry& entry) {
    const ltc::Contour contour(rectangle.begin(), rectangle.end());
    return ltc::lobeFormFactor({&contour, 1}, entry);
}

}  // namespace polylume::fit
