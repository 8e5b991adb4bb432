// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "fit/score_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "brdf/ggx.hpp"
#include "brdf/oren_nayar.hpp"
#include "ltc/builtin_table.hpp"

namespace polylume::fit {
namespace {

TEST(ScoreTable, shippedGgxTableIsWithinItsLimits) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const TableScore score = scoreTable(brdf::Ggx(), table);
    // The project's limit between nodes is 0.095; this is about what the fit reaches, so that a
    // loss of it shows. Nodes crowd at grazing views, where lobes fit worst.
    EXPECT_LE(score.betweenNodes, 0.068);
    EXPECT_LE(score.atNodes, 0.077);
    EXPECT_LE(score.albedoError, 0.002);
    // The published attributes are these figures, rounded to 4 digits.
    EXPECT_NEAR(std::stod(table.attributes().at("scoreBetweenNodes")), score.betweenNodes, 6e-5);
    EXPECT_NEAR(std::stod(table.attributes().at("scoreAtNodes")), score.atNodes, 6e-5);
}

TEST(ScoreTable, seesATableWhoseLobesAreTooWide) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    std::vector<float> values(table.values().begin(), table.values().end());
    const auto valueCount = static_cast<std::size_t>(table.layout().valueCount());
    for (std::size_t i = 0; i < values.size(); i += valueCount) values[i + 3] *= 2.0f;
    const ltc::Table twin(table.size(), values, table.attributes());
    EXPECT_GT(scoreTable(brdf::Ggx(), twin, 10).betweenNodes, 0.5);
}

TEST(ScoreTable, aSingleColumnCountsAtItsOwnRoughness) {
    // Lambert's lobe for all views, which Oren-Nayar is at roughness 0 alone.
    ltc::TableLayout layout;
    layout.reference = ltc::LobeReference::bisector;
    std::map<std::string, std::string> attributes = layout.attributes();
    attributes["brdf"] = "oren-nayar";
    attributes["alphaFloor"] = "0";
    std::vector<float> values;
    constexpr int kRows = 32;
    for (int row = 0; row < kRows; ++row) {
        const double coordinate = static_cast<double>(row) / (kRows - 1);
        const ltc::LobeAxis axis =
            ltc::lobeAxis(layout.reference, 0.0, layout.cosThetaView(coordinate));
        ltc::TableNode node;
        node.codes[0] = ltc::encode(ltc::Lobe(), axis);
        const std::vector<float> packed = layout.pack(node);
        values.insert(values.end(), packed.begin(), packed.end());
    }
    const ltc::Table flat({1, kRows}, values, attributes);
    const TableScore score = scoreTable(brdf::OrenNayar(), flat, 8);
    EXPECT_LT(score.atNodes, 1e-6);        // float32 values,
    EXPECT_LT(score.betweenNodes, 0.005);  // and blends of lobes that turn with the row.
    attributes["roughness"] = "1";
    const ltc::Table rough({1, kRows}, values, attributes);
    EXPECT_GT(scoreTable(brdf::OrenNayar(), rough, 8).atNodes, 0.1);
}

/// The same integral by other means: importance sampling of GGX and of the lobe in equal parts.
double monteCarloError(double roughness, double cosTheta, const ltc::TableEntry& entry) {
    constexpr int kSampleCount = 400000;
    const brdf::Ggx ggx;
    const glm::dvec3 view = brdf::viewDirection(cosTheta);
    const double albedo = ggx.reflectance(roughness, cosTheta).albedo;
    const ltc::Lobe& own = entry.lobes[0];
    const double determinant = own.m11 * own.m33 - own.m13 * own.m31;
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double sum = 0.0;
    for (int i = 0; i < kSampleCount; ++i) {
        const double first = uniform(generator);
        const double second = uniform(generator);
        glm::dvec3 light;
        if (i % 2 == 0) {
            light = ggx.sample(view, roughness, {first, second});
        } else {
            const double azimuth = 2.0 * std::numbers::pi * second;
            const double planar = std::sqrt(first);
            const glm::dvec3 c(planar * std::cos(azimuth), planar * std::sin(azimuth),
                               std::sqrt(1.0 - first));
            light = glm::normalize(glm::dvec3((own.m33 * c.x - own.m13 * c.z) / determinant, c.y,
                                              (own.m11 * c.z - own.m31 * c.x) / determinant));
        }
        if (light.z <= 0.0) continue;
        const double lobe = ltc::lobeDensity(light, own);
        const double density = 0.5 * (ggx.density(view, light, roughness) + lobe);
        const double difference =
            ggx.evaluate(view, light, roughness) - entry.albedo * lobe / ltc::upperShare(own);
        sum += std::abs(difference) / (density * albedo);
    }
    return sum / kSampleCount;
}

TEST(ScoreTable, agreesWithMonteCarlo) {
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    for (const double roughness : {0.05, 0.107, 0.3, 0.6, 1.0}) {
        for (const double degrees : {0.0, 41.0, 70.0, 85.0}) {
            const double cosTheta = std::cos(degrees * std::numbers::pi / 180.0);
            const ltc::TableEntry entry = table.lookup(roughness, cosTheta);
            // 400000 samples of a spread of about 1.
            EXPECT_NEAR(scoreEntry(brdf::Ggx(), roughness, cosTheta, entry),
                        monteCarloError(roughness, cosTheta, entry), 0.005)
                << roughness << " " << degrees;
        }
    }
}

}  // namespace
}  // namespace polylume::fit
