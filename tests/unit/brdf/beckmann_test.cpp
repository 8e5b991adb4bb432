// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "brdf/beckmann.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/brdf/brdf_checks.hpp"

namespace polylume::brdf {
namespace {

const glm::dvec3 kNormal(0.0, 0.0, 1.0);

TEST(Beckmann, distributionOfNormalsFillsTheSurface) {
    for (const double alpha : {0.01, 0.3, 1.0}) {
        const double area = sphereIntegral(kNormal, alpha, [&](const glm::dvec3& h) {
            return beckmannDistribution(h, alpha) * h.z;
        });
        EXPECT_NEAR(area, 1.0, 1e-9) << alpha;
    }
}

TEST(Beckmann, lambdaIsTheShareOfHiddenNormals) {
    // Smith's Lambda by what defines it: the facets seen cover the surface as seen, 1 + Lambda
    // times (Heitz 2014, eq. 17).
    for (const double alpha : {0.1, 0.5, 1.0}) {
        for (const double cosTheta : {0.9, 0.5, 0.1, 0.02}) {
            const glm::dvec3 view = viewDirection(cosTheta);
            const double seen = sphereIntegral(kNormal, alpha, [&](const glm::dvec3& h) {
                return std::max(0.0, glm::dot(view, h)) * beckmannDistribution(h, alpha);
            });
            // The rule has a kink where facets turn away.
            EXPECT_NEAR((1.0 + beckmannLambda(view, alpha)) * cosTheta, seen, 2e-5)
                << alpha << " " << cosTheta;
        }
    }
}

TEST(Beckmann, lambdaHasItsTabulatedValues) {
    // At alpha tan(theta) = 1: (exp(-1) / sqrt(pi) - erfc(1)) / 2.
    EXPECT_NEAR(beckmannLambda(viewDirection(std::sqrt(0.5)), 1.0), 0.025127270830, 1e-11);
    EXPECT_EQ(beckmannLambda(kNormal, 1.0), 0.0);
    EXPECT_LT(beckmannLambda(viewDirection(0.5), 0.01), 1e-300);
    // Near the horizon, 1 / (2 a sqrt(pi)) - 1/2.
    EXPECT_NEAR(beckmannLambda(viewDirection(1e-4), 1.0), 0.5e4 / std::sqrt(std::numbers::pi) - 0.5,
                1e-3);
}

TEST(Beckmann, smoothSurfacesLoseNothing) {
    const Beckmann beckmann;
    EXPECT_NEAR(beckmann.reflectance(0.0, 1.0).albedo, 1.0, 1e-6);
    EXPECT_NEAR(beckmann.reflectance(0.0, 0.5).fresnel, std::pow(0.5, 5), 1e-6);
    EXPECT_NEAR(beckmann.reflectance(0.1, 0.5).albedo, 1.0, 1e-3);
}

TEST(Beckmann, sampleWeightsStayBelowOne) {
    // Visible normals leave the weight G2 / G1.
    const Beckmann beckmann;
    for (const double roughness : {0.0, 0.3, 1.0}) {
        for (const double cosTheta : {1.0, 0.3, 0.01, 1e-4}) {
            const glm::dvec3 view = viewDirection(cosTheta);
            for (int i = 0; i < 400; ++i) {
                const int row = i / 20;
                const glm::dvec2 random((row + 0.5) / 20.0, (i % 20 + 0.5) / 20.0);
                const glm::dvec3 light = beckmann.sample(view, roughness, random);
                const double density = beckmann.density(view, light, roughness);
                ASSERT_GT(density, 0.0) << roughness << " " << cosTheta;
                ASSERT_LE(beckmann.evaluate(view, light, roughness), density * (1.0 + 1e-9));
            }
        }
    }
}

}  // namespace
}  // namespace polylume::brdf
