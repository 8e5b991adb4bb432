// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/ggx.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace polylume::brdf {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRoughnesses[] = {0.0, 0.05, 0.2, 0.5, 0.8, 1.0};
constexpr double kCosines[] = {1.0, 0.7, 0.3, 0.05};

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
