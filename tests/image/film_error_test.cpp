// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "configuration_pictures.hpp"
#include "figures/error_measures.hpp"
#include "shape_configurations.hpp"

// Rectangles that show a film, against ray tracing: how well a few reads of a prefiltered image
// stand for the integral over it. A mean over the whole set that is larger by more than a tenth
// than the one published fails. POLYLUME_PRINT_ERRORS=1 prints the errors.
namespace polylume {
namespace {

using test::Configuration;

struct Case {
    const char* name;
    Lobes lobes;
    Quality quality;
    double published;  ///< The mean error.
};

class FilmErrorTest : public ::testing::TestWithParam<Case> {
  protected:
    /// Root mean square error over the mean: of a metal, or of the diffuse reflection alone.
    static double errorOf(const Configuration& configuration) {
        const auto& [name, lobes, quality, published] = GetParam();
        scene::Scene scene = configuration.scene();
        if (lobes == Lobes::diffuse) {
            scene.materials.front().metallicFactor = 0.0f;
            scene.materials.front().baseColorFactor = {0.5f, 0.5f, 0.5f, 1.0f};
        }
        const test::ConfigurationView view{configuration, std::move(scene), lobes, {40, 24}};
        const FloatImage truth = test::traceConfiguration(view, 0.01, 1 << 16);
        return figures::measureErrors(test::drawConfiguration(view, quality), truth).relativeRmse;
    }
};

TEST_P(FilmErrorTest, isNotLargerThanStated) {
    const bool prints = std::getenv("POLYLUME_PRINT_ERRORS") != nullptr;
    const std::vector<Configuration> configurations = test::filmConfigurations();
    double mean = 0.0;
    for (const Configuration& configuration : configurations) {
        const double error = errorOf(configuration);
        if (prints) std::cout << configuration.name() << ": " << 100.0 * error << " %\n";
        mean += error / static_cast<double>(configurations.size());
    }
    if (prints) std::cout << "mean: " << 100.0 * mean << " %\n";
    const Case& known = GetParam();
    EXPECT_LT(mean, 1.1 * known.published);
    if (known.quality == Quality::high) {
        EXPECT_LE(mean, 0.08);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All, FilmErrorTest,
    ::testing::Values(Case{"diffuse", Lobes::diffuse, Quality::standard, 0.0957},
                      Case{"diffuseHigh", Lobes::diffuse, Quality::high, 0.0553},
                      Case{"metal", Lobes::specular, Quality::standard, 0.1402},
                      Case{"metalHigh", Lobes::specular, Quality::high, 0.0665}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace polylume
