// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/ggx.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "brdf/quadrature.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoughnesses[] = {0.0, 0.05, 0.2, 0.5, 0.8, 1.0};
constexpr double kCosines[] = {1.0, 0.7, 0.3, 0.05};

/// GGX with a factor that breaks one of its properties, for the tests' own test.
class SkewedGgx : public Ggx {
  public:
    double evaluate(const glm::dvec3& view, const glm::dvec3& light,
                    double roughness) const override {
        return Ggx::evaluate(view, light, roughness) * (1.0 + 0.1 * view.z);
    }
    double density(const glm::dvec3& view, const glm::dvec3& light,
                   double roughness) const override {
        return Ggx::density(view, light, roughness) * (1.0 + 0.1 * light.x);
    }
};

/// Uses nothing but the five functions that a new BRDF has to have.
class PlainGgx : public Ggx {
  public:
    std::vector<HemispherePoint> quadrature(const glm::dvec3& view, double roughness,
                                            int resolution) const override {
        return Brdf::quadrature(view, roughness, resolution);
    }
    Reflectance reflectance(double roughness, double cosThetaView) const override {
        return Brdf::reflectance(roughness, cosThetaView);
    }
};

glm::dvec3 randomUpper(std::mt19937_64& generator) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double z = uniform(generator);
    const double azimuth = 2.0 * kPi * uniform(generator);
    const double planar = std::sqrt(1.0 - z * z);
    return {planar * std::cos(azimuth), planar * std::sin(azimuth), std::max(z, 1e-3)};
}

double largestReciprocityError(const Brdf& brdf) {
    std::mt19937_64 generator(1);
    double largest = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const glm::dvec3 a = glm::normalize(randomUpper(generator));
        const glm::dvec3 b = glm::normalize(randomUpper(generator));
        const double roughness = kRoughnesses[i % std::size(kRoughnesses)];
        // evaluate() carries the cosine of its second direction.
        const double forward = brdf.evaluate(a, b, roughness) * a.z;
        const double backward = brdf.evaluate(b, a, roughness) * b.z;
        largest = std::max(largest, std::abs(forward - backward) / std::max(forward, 1e-300));
    }
    return largest;
}

TEST(Ggx, isReciprocal) {
    // Rounding of the half vector, amplified for small alpha.
    EXPECT_LT(largestReciprocityError(Ggx()), 1e-12);
    EXPECT_GT(largestReciprocityError(SkewedGgx()), 1e-3);
}

TEST(Ggx, albedoAtAlphaOneHasItsClosedForm) {
    // 1 - c ln(1 + 1/c) for height-correlated Smith; separable Smith agrees at c = 1 only.
    const Ggx ggx;
    for (const double c : {1.0, 0.9, 0.5, 0.2, 0.05, 0.01, 0.001}) {
        const double expected = 1.0 - c * std::log(1.0 + 1.0 / c);
        EXPECT_NEAR(ggx.reflectance(1.0, c).albedo, expected, 1e-10) << "cosine " << c;
    }
    EXPECT_NEAR(ggx.reflectance(1.0, 1.0).albedo, 0.306853, 1e-6);
    EXPECT_NEAR(ggx.reflectance(1.0, 0.5).albedo, 0.450694, 1e-6);
    EXPECT_NEAR(ggx.reflectance(1.0, 0.2).albedo, 0.641648, 1e-6);
}

TEST(Ggx, whiteFurnaceNeverGainsEnergyAndSmoothSurfacesLoseNone) {
    const Ggx ggx;
    for (int i = 0; i <= 63; ++i) {
        for (int j = 0; j <= 63; ++j) {
            const Reflectance result = ggx.reflectance(i / 63.0, 1.0 - j * j / 3969.0);
            ASSERT_GT(result.albedo, 0.0);
            ASSERT_LE(result.albedo, 1.0 + 1e-9) << "column " << i << " row " << j;
            ASSERT_GE(result.fresnel, 0.0);
            ASSERT_LE(result.fresnel, result.albedo);
        }
    }
    EXPECT_NEAR(ggx.reflectance(0.0, 1.0).albedo, 1.0, 1e-6);
    EXPECT_NEAR(ggx.reflectance(0.0, 0.5).fresnel, std::pow(0.5, 5), 1e-6);
}

TEST(Ggx, reflectanceAgreesWithAFinerRuleOfAnotherKind) {
    const Ggx ggx;
    for (const double roughness : kRoughnesses) {
        for (const double cosTheta : kCosines) {
            const glm::dvec3 view = viewDirection(cosTheta);
            double albedo = 0.0;
            double fresnel = 0.0;
            for (const HemispherePoint& point : ggx.quadrature(view, roughness, 256)) {
                const double value =
                    ggx.evaluate(view, point.direction, roughness) * point.solidAngle;
                albedo += value;
                fresnel += value * fresnelWeight(view, point.direction);
            }
            const Reflectance result = ggx.reflectance(roughness, cosTheta);
            // The plain Gauss rule converges slowly at the lobe's edge.
            EXPECT_NEAR(result.albedo, albedo, 1e-6) << roughness << " " << cosTheta;
            EXPECT_NEAR(result.fresnel, fresnel, 1e-6) << roughness << " " << cosTheta;
        }
    }
}

TEST(Ggx, quadratureCoversTheHemisphere) {
    const Ggx ggx;
    for (const double cosTheta : kCosines) {
        double solidAngle = 0.0;
        double cosine = 0.0;
        for (const HemispherePoint& point : ggx.quadrature(viewDirection(cosTheta), 0.6, 96)) {
            solidAngle += point.solidAngle;
            cosine += point.solidAngle * point.direction.z;
            ASSERT_GE(point.direction.y, 0.0);
        }
        EXPECT_NEAR(solidAngle, 2.0 * kPi, 1e-6);
        EXPECT_NEAR(cosine, kPi, 1e-6);
    }
}

TEST(Ggx, aBrdfOfFiveFunctionsGetsTheSameReflectance) {
    const PlainGgx plain;
    const Ggx ggx;
    for (const double roughness : {0.2, 0.5, 1.0}) {
        for (const double cosTheta : kCosines) {
            // A rule of 256 x 256 over an integrand that has a kink where light falls below.
            EXPECT_NEAR(plain.reflectance(roughness, cosTheta).albedo,
                        ggx.reflectance(roughness, cosTheta).albedo, 2e-4);
        }
    }
}

/// Integral of the density over the sphere, about the mirror direction, where the lobe is.
double densityIntegral(const Brdf& brdf, double cosTheta, double roughness) {
    const glm::dvec3 view = viewDirection(cosTheta);
    const glm::dvec3 axis(-view.x, 0.0, view.z);
    const glm::dvec3 side(0.0, 1.0, 0.0);
    const glm::dvec3 up = glm::cross(axis, side);
    const double alpha = ggxAlpha(roughness);
    const std::vector<QuadratureNode> us = tanhSinh(400);
    const std::vector<QuadratureNode> vs = gaussLegendre(400);
    double sum = 0.0;
    for (const QuadratureNode& u : us) {
        // tan(half the polar angle) = alpha t, t = u / (1 - u): even over a narrow lobe's
        // logarithm.
        const double t = alpha * u.position / (1.0 - u.position);
        const double tRate = alpha / ((1.0 - u.position) * (1.0 - u.position));
        const double sine = 2.0 * t / (1.0 + t * t);
        const double cosine = (1.0 - t * t) / (1.0 + t * t);
        const double rate = sine * 2.0 / (1.0 + t * t) * tRate;
        for (const QuadratureNode& v : vs) {
            const double azimuth = 2.0 * kPi * v.position;
            const glm::dvec3 light =
                cosine * axis + sine * (std::cos(azimuth) * side + std::sin(azimuth) * up);
            sum += brdf.density(view, light, roughness) * rate * u.weight * v.weight * 2.0 * kPi;
        }
    }
    return sum;
}

TEST(Ggx, densityIntegratesToOneOverTheSphere) {
    for (const double roughness : {0.1, 0.5, 1.0}) {
        for (const double cosTheta : {1.0, 0.7, 0.3}) {
            // The density jumps where half vectors reach the horizon.
            EXPECT_NEAR(densityIntegral(Ggx(), cosTheta, roughness), 1.0, 2e-3)
                << roughness << " " << cosTheta;
        }
    }
    EXPECT_GT(std::abs(densityIntegral(SkewedGgx(), 0.7, 0.1) - 1.0), 2e-3);
}

/// Pearson's chi-square over cells of the sphere, over its degrees of freedom.
double reducedChiSquare(const Brdf& brdf, double cosTheta, double roughness) {
    constexpr int kThetas = 20;
    constexpr int kPhis = 40;
    constexpr int kSampleCount = 400000;
    const glm::dvec3 view = viewDirection(cosTheta);
    std::vector<double> counts(kThetas * kPhis, 0.0);
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int i = 0; i < kSampleCount; ++i) {
        const double first = uniform(generator);
        const glm::dvec3 light = brdf.sample(view, roughness, {first, uniform(generator)});
        const double azimuth = std::atan2(light.y, light.x) / (2.0 * kPi) + 0.5;
        const int theta =
            std::clamp(static_cast<int>((1.0 - light.z) * 0.5 * kThetas), 0, kThetas - 1);
        const int phi = std::clamp(static_cast<int>(azimuth * kPhis), 0, kPhis - 1);
        counts[theta * kPhis + phi] += 1.0;
    }
    const std::vector<QuadratureNode> rule = gaussLegendre(24);
    double chiSquare = 0.0;
    double pooledCount = 0.0;
    double pooledExpected = 0.0;
    int freedom = -1;
    const auto addCell = [&](double count, double expected) {
        chiSquare += (count - expected) * (count - expected) / expected;
        ++freedom;
    };
    for (int theta = 0; theta < kThetas; ++theta) {
        for (int phi = 0; phi < kPhis; ++phi) {
            double expected = 0.0;
            for (const QuadratureNode& u : rule) {
                const double z = 1.0 - 2.0 * (theta + u.position) / kThetas;
                const double planar = std::sqrt(1.0 - z * z);
                for (const QuadratureNode& v : rule) {
                    const double azimuth = 2.0 * kPi * ((phi + v.position) / kPhis - 0.5);
                    const glm::dvec3 light(planar * std::cos(azimuth), planar * std::sin(azimuth),
                                           z);
                    expected += brdf.density(view, light, roughness) * u.weight * v.weight;
                }
            }
            expected *= kSampleCount * 4.0 * kPi / (kThetas * kPhis);
            const double count = counts[theta * kPhis + phi];
            // Cells of few samples are pooled, as the test's distribution asks.
            if (expected < 10.0) {
                pooledCount += count;
                pooledExpected += expected;
            } else {
                addCell(count, expected);
            }
        }
    }
    if (pooledExpected >= 10.0) addCell(pooledCount, pooledExpected);
    return chiSquare / freedom;
}

TEST(Ggx, samplesFollowTheirDensity) {
    for (const double roughness : {0.5, 0.8, 1.0}) {
        for (const double cosTheta : {1.0, 0.6, 0.2}) {
            // Some 300 degrees of freedom: 1 +- 0.08; the seed is fixed.
            EXPECT_LT(reducedChiSquare(Ggx(), cosTheta, roughness), 1.35) << roughness << cosTheta;
        }
    }
    EXPECT_GT(reducedChiSquare(SkewedGgx(), 0.6, 0.8), 2.0);
}

TEST(Ggx, isFiniteAtTheEndsOfItsRange) {
    const Ggx ggx;
    for (const double roughness : {0.0, 1e-9, 1.0}) {
        for (const double cosTheta : {0.0, 1e-12, 1.0}) {
            const Reflectance result = ggx.reflectance(roughness, cosTheta);
            EXPECT_TRUE(std::isfinite(result.albedo) && std::isfinite(result.fresnel));
            const glm::dvec3 view = viewDirection(cosTheta);
            const glm::dvec3 mirror(-view.x, -view.y, view.z);
            EXPECT_TRUE(std::isfinite(ggx.evaluate(view, mirror, roughness)));
            EXPECT_EQ(ggx.evaluate(view, -mirror, roughness), 0.0);
            EXPECT_EQ(ggx.evaluate({1.0, 0.0, 0.0}, mirror, roughness), 0.0);
        }
    }
}

}  // namespace
}  // namespace polylume::brdf
