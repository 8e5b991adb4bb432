// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "unit/brdf/brdf_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;

glm::dvec3 randomUpper(std::mt19937_64& generator) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double z = std::max(uniform(generator), 1e-3);
    const double azimuth = 2.0 * kPi * uniform(generator);
    const double planar = std::sqrt(1.0 - z * z);
    return {planar * std::cos(azimuth), planar * std::sin(azimuth), z};
}

/// Cells of equal solid angle.
constexpr int kHeights = 20;
constexpr int kAzimuths = 40;
constexpr std::size_t kCellCount = std::size_t{kHeights} * kAzimuths;
constexpr int kSampleCount = 200000;

std::vector<double> countSamples(const Brdf& brdf, const glm::dvec3& view, double roughness) {
    std::vector<double> counts(kCellCount, 0.0);
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < kSampleCount; ++i) {
        const double first = uniform(generator);
        const glm::dvec3 light = brdf.sample(view, roughness, {first, uniform(generator)});
        const double turn = std::atan2(light.y, light.x) / (2.0 * kPi) + 0.5;
        const int height =
            std::clamp(static_cast<int>((1.0 - light.z) * 0.5 * kHeights), 0, kHeights - 1);
        const int azimuth = std::clamp(static_cast<int>(turn * kAzimuths), 0, kAzimuths - 1);
        counts[height * kAzimuths + azimuth] += 1.0;
    }
    return counts;
}

std::vector<double> expectSamples(const Brdf& brdf, const glm::dvec3& view, double roughness) {
    std::vector<double> expected(kCellCount, 0.0);
    const std::vector<QuadratureNode> rule = gaussLegendre(16);
    for (std::size_t cell = 0; cell < kCellCount; ++cell) {
        const std::size_t height = cell / kAzimuths;
        const std::size_t azimuth = cell % kAzimuths;
        for (const QuadratureNode& u : rule) {
            const double z = 1.0 - 2.0 * (static_cast<double>(height) + u.position) / kHeights;
            const double planar = std::sqrt(1.0 - z * z);
            for (const QuadratureNode& v : rule) {
                const double turn = (static_cast<double>(azimuth) + v.position) / kAzimuths - 0.5;
                const glm::dvec3 light(planar * std::cos(2.0 * kPi * turn),
                                       planar * std::sin(2.0 * kPi * turn), z);
                expected[cell] += brdf.density(view, light, roughness) * u.weight * v.weight;
            }
        }
        expected[cell] *= kSampleCount * 4.0 * kPi / kCellCount;
    }
    return expected;
}

}  // namespace

double largestReciprocityError(const Brdf& brdf) {
    std::mt19937_64 generator(1);
    double largest = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec3 a = randomUpper(generator);
        const glm::dvec3 b = randomUpper(generator);
        const double roughness = (i % 21) / 20.0;
        // evaluate() carries the cosine of its second direction.
        const double forward = brdf.evaluate(a, b, roughness) * a.z;
        const double backward = brdf.evaluate(b, a, roughness) * b.z;
        largest = std::max(largest, std::abs(forward - backward) / std::max(forward, 1e-200));
    }
    return largest;
}

double sphereIntegral(const glm::dvec3& axis, double width,
                      const std::function<double(const glm::dvec3&)>& function) {
    const glm::dvec3 side(0.0, 1.0, 0.0);  // Any axis here lies in the xz plane.
    const glm::dvec3 up = glm::cross(axis, side);
    // Parted where circles about the axis touch the horizon, and at 90 degrees.
    const auto position = [&](double polar) {
        const double t = std::tan(0.5 * polar) / width;
        return t / (1.0 + t);
    };
    const double elevation = std::asin(axis.z);
    const std::vector<QuadratureNode> us = spreadBetween(
        tanhSinh, 400,
        {0.0, position(elevation), position(0.5 * kPi), position(kPi - elevation), 1.0});
    static const std::vector<QuadratureNode> vs = gaussLegendre(400);
    double sum = 0.0;
    for (const QuadratureNode& u : us) {
        // tan(half the polar angle) = width t, t = u / (1 - u).
        const double rest = std::max(1.0 - u.position, 1e-14);
        const double t = width * u.position / rest;
        const double tRate = width / (rest * rest);
        const double sine = 2.0 * t / (1.0 + t * t);
        const double cosine = (1.0 - t * t) / (1.0 + t * t);
        const double rate = sine * 2.0 / (1.0 + t * t) * tRate * u.weight;
        for (const QuadratureNode& v : vs) {
            const double azimuth = 2.0 * kPi * v.position;
            const glm::dvec3 light =
                cosine * axis + sine * (std::cos(azimuth) * side + std::sin(azimuth) * up);
            sum += function(light) * rate * v.weight * 2.0 * kPi;
        }
    }
    return sum;
}

LobeFrame lobeFrame(const Brdf& brdf, const glm::dvec3& view, double roughness) {
    if (!brdf.followsMirror()) return {glm::dvec3(0.0, 0.0, 1.0), 1.0};
    const double alpha = brdf.hasRoughness() ? roughness * roughness : 0.2;
    return {glm::dvec3(-view.x, -view.y, view.z), std::max(alpha, brdf.alphaFloor())};
}

double bruteForceAlbedo(const Brdf& brdf, double cosTheta, double roughness) {
    const glm::dvec3 view = viewDirection(cosTheta);
    const LobeFrame frame = lobeFrame(brdf, view, roughness);
    return sphereIntegral(frame.axis, frame.width, [&](const glm::dvec3& light) {
        return brdf.evaluate(view, light, roughness);
    });
}

double densityIntegral(const Brdf& brdf, double cosTheta, double roughness) {
    const glm::dvec3 view = viewDirection(cosTheta);
    const LobeFrame frame = lobeFrame(brdf, view, roughness);
    return sphereIntegral(frame.axis, frame.width, [&](const glm::dvec3& light) {
        return brdf.density(view, light, roughness);
    });
}

double chiSquareDeviation(const Brdf& brdf, double cosTheta, double roughness) {
    const glm::dvec3 view = viewDirection(cosTheta);
    const std::vector<double> counts = countSamples(brdf, view, roughness);
    const std::vector<double> expected = expectSamples(brdf, view, roughness);
    double chiSquare = 0.0;
    double pooledCount = 0.0;
    double pooledExpected = 0.0;
    int freedom = -1;
    const auto addCell = [&](double found, double mean) {
        chiSquare += (found - mean) * (found - mean) / mean;
        ++freedom;
    };
    for (std::size_t cell = 0; cell < counts.size(); ++cell) {
        // Cells of few samples are pooled, as the test's distribution asks.
        if (expected[cell] < 10.0) {
            pooledCount += counts[cell];
            pooledExpected += expected[cell];
        } else {
            addCell(counts[cell], expected[cell]);
        }
    }
    if (pooledExpected >= 10.0) addCell(pooledCount, pooledExpected);
    return (chiSquare - freedom) / std::sqrt(2.0 * freedom);
}

}  // namespace polylume::brdf
