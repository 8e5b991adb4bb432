// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "configuration_pictures.hpp"
#include "figures/error_measures.hpp"
#include "ltc/builtin_table.hpp"
#include "polygon_path.hpp"
#include "shape_configurations.hpp"

// Every shape of light against ray tracing. The polygon integral in double, given the outline as
// each point sees it, is the yardstick of what linearly transformed cosines can reach at all.
// POLYLUME_PRINT_ERRORS=1 prints the errors.
namespace polylume {
namespace {

using figures::ErrorMeasures;
using test::Configuration;
using test::Placement;
using test::Shape;

/// Of a picture of the specular reflection, and of the diffuse one, which is smooth.
constexpr glm::ivec2 kSize{40, 24};
constexpr glm::ivec2 kDiffuseSize{24, 14};

bool printsErrors() {
    return std::getenv("POLYLUME_PRINT_ERRORS") != nullptr;
}

/// The floor of configuration, which diffuse light needs as no metal.
scene::Scene sceneOf(const Configuration& configuration, Lobes lobes) {
    scene::Scene scene = configuration.scene();
    if (lobes == Lobes::diffuse) {
        scene.materials.front().metallicFactor = 0.0f;
        scene.materials.front().specularFactor = 0.0f;
    }
    return scene;
}

class ShapeErrorTest : public ::testing::TestWithParam<Configuration> {
  protected:
    static test::ConfigurationView viewOf(Lobes lobes) {
        return {GetParam(), sceneOf(GetParam(), lobes), lobes,
                lobes == Lobes::diffuse ? kDiffuseSize : kSize};
    }

    static FloatImage draw(Lobes lobes) {
        return test::drawConfiguration(viewOf(lobes), Quality::standard,
                                       {"position", "normal", "roughness"});
    }

    static FloatImage trace(Lobes lobes, double error) {
        return test::traceConfiguration(viewOf(lobes), error, 1 << 20);
    }

    /// `drawn` with the colours that the polygon path gives its surfaces.
    FloatImage followPolygonPath(FloatImage drawn, int vertexCount) const {
        const LightSet lights = GetParam().lights();
        const glm::dvec3 eye(GetParam().camera().worldFromCamera[3]);
        const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
        const std::size_t position = drawn.channelIndex("position.X").value();
        const std::size_t roughness = drawn.channelIndex("roughness.Y").value();
        for (int y = 0; y < drawn.height; ++y) {
            for (int x = 0; x < drawn.width; ++x) {
                float* pixel = drawn.pixel(x, y);
                if (!(pixel[3] > 0.0f)) continue;
                test::PathPoint point{{pixel[position], pixel[position + 1], pixel[position + 2]},
                                      {0.0, 1.0, 0.0},
                                      {}};
                point.view = glm::normalize(eye - point.position);
                const ltc::TableEntry entry = table.lookup(pixel[roughness], point.view.y);
                const auto parts = test::outlinesAt(lights, point.position, vertexCount);
                const double factor = test::polygonPath(parts, point, entry).specular;
                const auto radiance = static_cast<float>(100.0 * entry.albedo * factor);
                for (int c = 0; c < 3; ++c) pixel[c] = radiance;
            }
        }
        return drawn;
    }

    static void print(const char* what, const ErrorMeasures& measured, double limit) {
        if (!printsErrors()) return;
        std::cout << GetParam().name() << ' ' << what << ": " << 100.0 * measured.relativeRmse
                  << " %, limit " << 100.0 * limit << " %, noise " << 100.0 * measured.noise
                  << " %\n";
    }
};

/// Lambert's reflection does not depend on roughness.
class DiffuseErrorTest : public ShapeErrorTest {};

TEST_P(DiffuseErrorTest, isAlmostNothing) {
    const bool isRound = GetParam().shape == Shape::sphere || GetParam().shape == Shape::disk;
    const double limit = isRound && GetParam().placement == Placement::horizon ? 0.005 : 0.002;
    const ErrorMeasures measured =
        figures::measureErrors(draw(Lobes::diffuse), trace(Lobes::diffuse, 0.18 * limit));
    print("diffuse", measured, limit);
    EXPECT_LT(measured.noise, limit / 5.0);
    EXPECT_LE(measured.relativeRmse, limit);
}

TEST_P(ShapeErrorTest, isThatOfItsOutlineAsAPolygon) {
    const FloatImage drawn = draw(Lobes::specular);
    // A polygon of few vertices differs from the outline by as much as a smooth lobe errs, to
    // either side: by chance it may be nearer to the truth than the outline itself, which many
    // vertices are.
    const FloatImage coarse = followPolygonPath(drawn, 64);
    const FloatImage fine = followPolygonPath(drawn, 512);
    // Below this both are right, and the truth would take minutes to say by how much.
    constexpr double kNoError = 0.0005;
    // The truth has to be better than what is judged by it, which only the truth tells.
    double target = 0.01;
    double limit = 0.0;
    double byCoarse = 0.0;
    ErrorMeasures measured;
    for (int i = 0; i < 6; ++i) {
        const FloatImage truth = trace(Lobes::specular, target);
        byCoarse = figures::measureErrors(coarse, truth).relativeRmse;
        const double byFine = figures::measureErrors(fine, truth).relativeRmse;
        limit = 1.2 * std::max({byCoarse, byFine, kNoError});
        measured = figures::measureErrors(drawn, truth);
        if (measured.noise < limit / 5.0) break;
        target = std::max(0.15 * limit, 0.25 * target);
    }
    print("specular", measured, limit);
    if (printsErrors()) std::cout << "  as 64 vertices " << 100.0 * byCoarse << " %\n";
    EXPECT_LT(measured.noise, limit / 5.0);
    EXPECT_LE(measured.relativeRmse, limit);
}

std::vector<Configuration> diffuseConfigurations() {
    std::vector<Configuration> all;
    for (const Configuration& configuration : test::shapeConfigurations()) {
        if (configuration.roughness == 1.0) all.push_back(configuration);
    }
    return all;
}

const auto kNames = [](const auto& test) { return test.param.name(); };
INSTANTIATE_TEST_SUITE_P(All, DiffuseErrorTest, ::testing::ValuesIn(diffuseConfigurations()),
                         kNames);
INSTANTIATE_TEST_SUITE_P(All, ShapeErrorTest, ::testing::ValuesIn(test::shapeConfigurations()),
                         kNames);

}  // namespace
}  // namespace polylume
