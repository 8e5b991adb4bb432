// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/brdf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "brdf/burley_diffuse.hpp"
#include "brdf/charlie_sheen.hpp"
#include "brdf/ggx.hpp"
#include "brdf/merl_brdf.hpp"
#include "brdf/oren_nayar.hpp"
#include "brdf/registry.hpp"
#include "unit/brdf/brdf_checks.hpp"
#include "unit/brdf/merl_samples.hpp"

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoughnesses[] = {0.0, 0.1, 0.3, 0.6, 1.0};
constexpr double kCosines[] = {1.0, 0.7, 0.3, 0.05};

/// What all BRDFs have to keep, each by its name; "merl" is measured from GGX at r = 0.5.
class AllBrdfs : public testing::TestWithParam<std::string> {
  protected:
    AllBrdfs() {
        if (GetParam() == "merl") {
            brdf_ = std::make_unique<MerlBrdf>(
                "merl", measureMerlSamples(Ggx(), 0.5, glm::vec3(1.0f, 0.8f, 0.5f)));
        } else {
            brdf_ = makeBrdf(GetParam());
        }
    }

    /// The roughnesses to look at: one is enough where nothing depends on it.
    std::vector<double> roughnesses() const {
        if (!brdf_->hasRoughness()) return {0.5};
        return {std::begin(kRoughnesses), std::end(kRoughnesses)};
    }

    std::unique_ptr<Brdf> brdf_;
};

TEST_P(AllBrdfs, isReciprocal) {
    // Rounding of the half vector, amplified for small alpha.
    EXPECT_LT(largestReciprocityError(*brdf_), 1e-8);
    EXPECT_GT(largestReciprocityError(SkewedBrdf(*brdf_)), 1e-3);
}

TEST_P(AllBrdfs, albedoAgreesWithBruteForce) {
    for (const double roughness : roughnesses()) {
        for (const double cosTheta : kCosines) {
            const double expected = bruteForceAlbedo(*brdf_, cosTheta, roughness);
            // The brute force has kinks at the horizon and where the models have some.
            EXPECT_NEAR(brdf_->reflectance(roughness, cosTheta).albedo, expected, 1e-4)
                << roughness << " " << cosTheta;
        }
    }
    const SkewedBrdf skewed(*brdf_);
    EXPECT_GT(std::abs(bruteForceAlbedo(skewed, 0.7, 0.6) - brdf_->reflectance(0.6, 0.7).albedo),
              1e-3);
}

TEST_P(AllBrdfs, quadratureConvergesOnTheReflectance) {
    // Measured data has a kink at every sample, and they are far apart for a grazing view.
    const double coarse = brdf_->hasRoughness() ? 1e-5 : 2e-3;
    const double fine = brdf_->hasRoughness() ? 1e-6 : 2e-3;
    for (const double roughness : roughnesses()) {
        for (const double cosTheta : {1.0, 0.99, 0.7, 0.3, 0.05, 0.01, 1e-4}) {
            const glm::dvec3 view = viewDirection(cosTheta);
            const Reflectance expected = brdf_->reflectance(roughness, cosTheta);
            for (const int resolution : {32, 64}) {
                double albedo = 0.0;
                double fresnel = 0.0;
                for (const auto& point : brdf_->quadrature(view, roughness, resolution)) {
                    ASSERT_GE(point.direction.y, 0.0);
                    ASSERT_GT(point.direction.z, 0.0);
                    ASSERT_NEAR(glm::length(point.direction), 1.0, 1e-9);
                    const double value =
                        brdf_->evaluate(view, point.direction, roughness) * point.solidAngle;
                    albedo += value;
                    fresnel += value * fresnelWeight(view, point.direction);
                }
                const double tolerance = resolution == 32 ? coarse : fine;
                EXPECT_NEAR(albedo, expected.albedo, tolerance) << roughness << " " << cosTheta;
                EXPECT_NEAR(fresnel, expected.fresnel, tolerance) << roughness << " " << cosTheta;
            }
        }
    }
}

TEST_P(AllBrdfs, quadratureCoversTheHemisphere) {
    for (const double cosTheta : {1.0, 0.7, 0.3, 0.05}) {
        double solidAngle = 0.0;
        double cosine = 0.0;
        for (const auto& point : brdf_->quadrature(viewDirection(cosTheta), 0.6, 64)) {
            solidAngle += point.solidAngle;
            cosine += point.solidAngle * point.direction.z;
        }
        // The rules crowd at the lobe, for which they are made, and are sparse elsewhere.
        EXPECT_NEAR(solidAngle, 2.0 * kPi, 1e-3) << cosTheta;
        EXPECT_NEAR(cosine, kPi, 1e-3) << cosTheta;
    }
}

TEST_P(AllBrdfs, densityIntegratesToOneOverTheSphere) {
    for (const double roughness : {0.1, 0.5, 1.0}) {
        for (const double cosTheta : {1.0, 0.7, 0.3}) {
            // The densities jump: at the horizon, where half vectors reach it, at measured cells.
            EXPECT_NEAR(densityIntegral(*brdf_, cosTheta, roughness), 1.0, 3e-3)
                << roughness << " " << cosTheta;
        }
    }
    EXPECT_GT(std::abs(densityIntegral(SkewedBrdf(*brdf_), 0.7, 0.5) - 1.0), 6e-3);
}

TEST_P(AllBrdfs, samplesFollowTheirDensity) {
    for (const double roughness : {0.5, 0.8, 1.0}) {
        for (const double cosTheta : {1.0, 0.6, 0.2}) {
            // The seed is fixed; over as many tests as here, 4 is not expected once in 400 seeds.
            EXPECT_LT(chiSquareDeviation(*brdf_, cosTheta, roughness), 4.0)
                << roughness << " " << cosTheta;
        }
    }
    EXPECT_GT(chiSquareDeviation(SkewedBrdf(*brdf_), 0.6, 0.8), 10.0);
}

TEST_P(AllBrdfs, samplesEstimateTheAlbedo) {
    // The even points of a lattice, so that the error is not that of random numbers.
    constexpr int kSide = 300;
    for (const double roughness : roughnesses()) {
        const glm::dvec3 view = viewDirection(0.5);
        double sum = 0.0;
        for (int i = 0; i < kSide * kSide; ++i) {
            const int row = i / kSide;
            const glm::dvec2 random((row + 0.5) / kSide, (i % kSide + 0.5) / kSide);
            const glm::dvec3 light = brdf_->sample(view, roughness, random);
            ASSERT_NEAR(glm::length(light), 1.0, 1e-9);
            if (light.z <= 0.0) continue;
            sum += brdf_->evaluate(view, light, roughness) / brdf_->density(view, light, roughness);
        }
        EXPECT_NEAR(sum / (kSide * kSide), brdf_->reflectance(roughness, 0.5).albedo, 2e-3)
            << roughness;
    }
}

TEST_P(AllBrdfs, whiteFurnaceGainsNoMoreThanIsKnown) {
    double known = 1.0;
    if (GetParam() == "burley") known = BurleyDiffuse::kLargestAlbedo;
    if (GetParam() == "oren-nayar") known = OrenNayar::kLargestAlbedo;
    for (const double roughness : roughnesses()) {
        for (int row = 0; row <= 24; ++row) {
            const Reflectance result = brdf_->reflectance(roughness, 1.0 - row * row / 576.0);
            EXPECT_GT(result.albedo, 0.0);
            EXPECT_LE(result.albedo, known + 1e-6) << roughness << " " << row;
            EXPECT_GE(result.fresnel, 0.0);
            EXPECT_LE(result.fresnel, result.albedo);
        }
    }
}

TEST_P(AllBrdfs, isFiniteEverywhere) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double heights[] = {1e-30, 1e-12, 1e-4, 0.3, 0.999999999, 1.0};
    for (const double roughness : {0.0, 1e-9, 0.1, 0.5, 1.0}) {
        for (const double viewZ : heights) {
            const glm::dvec3 view(std::sqrt(1.0 - viewZ * viewZ), 0.0, viewZ);
            for (const double lightZ : heights) {
                const double planar = std::sqrt(1.0 - lightZ * lightZ);
                for (const double turn : {0.0, 0.25, 0.4, 0.5}) {
                    const glm::dvec3 light(planar * std::cos(2.0 * kPi * turn),
                                           planar * std::sin(2.0 * kPi * turn), lightZ);
                    const double value = brdf_->evaluate(view, light, roughness);
                    ASSERT_TRUE(std::isfinite(value) && value >= 0.0) << viewZ << " " << lightZ;
                    ASSERT_EQ(brdf_->evaluate(view, -light, roughness), 0.0);
                    ASSERT_EQ(brdf_->evaluate(-view, light, roughness), 0.0);
                    ASSERT_TRUE(std::isfinite(brdf_->density(view, light, roughness)));
                }
            }
            for (int i = 0; i < 50; ++i) {
                const double ends[] = {0.0, 0.5, std::nextafter(1.0, 0.0), uniform(generator)};
                const glm::dvec3 light =
                    brdf_->sample(view, roughness, {ends[i % 4], ends[(i / 4) % 4]});
                ASSERT_NEAR(glm::length(light), 1.0, 1e-6) << roughness << " " << viewZ;
            }
        }
    }
}

std::vector<std::string> testedNames() {
    const std::vector<std::string_view> names = brdfNames();
    std::vector<std::string> tested(names.begin(), names.end());
    tested.emplace_back("merl");
    return tested;
}

INSTANTIATE_TEST_SUITE_P(Brdf, AllBrdfs, testing::ValuesIn(testedNames()), [](const auto& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace polylume::brdf
