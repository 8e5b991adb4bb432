// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "figures/comparison_scenes.hpp"
#include "figures/diverging_color.hpp"
#include "figures/error_measures.hpp"
#include "figures/shape_scenes.hpp"
#include "lights/light_image_sampling.hpp"
#include "lights/light_outline.hpp"
#include "polylume/light.hpp"

namespace polylume::figures {
namespace {

/// A picture of grey pixels of these values, wholly covered, with a standard error each.
FloatImage greyPicture(const std::vector<float>& values, float standardError) {
    FloatImage image;
    image.width = static_cast<int>(values.size());
    image.height = 1;
    image.channelNames = {
        "R", "G", "B", "A", "standardError.R", "standardError.G", "standardError.B"};
    for (const float value : values) {
        image.pixels.insert(image.pixels.end(), {value, value, value, 1.0f, standardError,
                                                 standardError, standardError});
    }
    return image;
}

TEST(ErrorMeasures, areWhatTheirNamesSay) {
    const FloatImage truth = greyPicture({1.0f, 2.0f, 5.0f, 0.0f}, 0.1f);
    const FloatImage ltc = greyPicture({1.5f, 1.0f, 5.0f, 0.0f}, 0.0f);
    const ErrorMeasures errors = measureErrors(ltc, truth);
    EXPECT_EQ(errors.pixelCount, 4);
    EXPECT_NEAR(errors.meanRelative, (0.5 + 0.5 + 0.0) / 3.0, 1e-6);
    EXPECT_NEAR(errors.meanAbsolute, (0.5 + 1.0) / 8.0, 1e-6);
    // The noise of the truth, 0.1 at each pixel, is no error of LTC.
    EXPECT_NEAR(errors.relativeRmse, std::sqrt((0.25 + 1.0) / 4.0 - 0.01) / 2.0, 1e-6);
    EXPECT_NEAR(errors.bias, -0.5 / 8.0, 1e-6);
    EXPECT_NEAR(errors.noise, 0.1 / 2.0, 1e-6);
    EXPECT_GT(errors.flip, 0.0);
}

TEST(ErrorMeasures, areZeroForTheTruthItself) {
    const FloatImage truth = greyPicture({1.0f, 2.0f, 5.0f}, 0.0f);
    const ErrorMeasures errors = measureErrors(truth, truth);
    EXPECT_EQ(errors.meanRelative, 0.0);
    EXPECT_EQ(errors.relativeRmse, 0.0);
    EXPECT_EQ(errors.bias, 0.0);
    EXPECT_EQ(errors.flip, 0.0);
}

TEST(ErrorMeasures, leaveOutWhatNoSurfaceCovers) {
    FloatImage truth = greyPicture({1.0f, 2.0f}, 0.0f);
    FloatImage ltc = greyPicture({1.0f, 9.0f}, 0.0f);
    EXPECT_GT(measureErrors(ltc, truth).meanRelative, 1.0);
    truth.pixel(1, 0)[3] = 0.5f;
    EXPECT_EQ(measureErrors(ltc, truth).pixelCount, 1);
    EXPECT_EQ(measureErrors(ltc, truth).meanRelative, 0.0);
    EXPECT_TRUE(std::isnan(relativeDifference(ltc, truth)[1]));
    EXPECT_EQ(relativeDifference(ltc, truth)[0], 0.0f);
}

TEST(ComparisonScenes, lightsFaceTheFloorInFrontOfThem) {
    std::vector<scene::Scene> scenes = {makeFloorScene(0.5)};
    for (FailureCase& failure : failureCases()) {
        EXPECT_FALSE(failure.cause.empty()) << failure.name;
        scenes.push_back(std::move(failure.scene));
    }
    for (const scene::Scene& scene : scenes) {
        ASSERT_EQ(scene.areaLights.size(), 1u);
        ASSERT_EQ(scene.cameras.size(), 1u);
        const auto& light = std::get<PolygonLight>(scene.areaLights[0].shape);
        EXPECT_GT(areaVector(light.contours.front()).z, 0.0);
    }
    const auto& wall = std::get<PolygonLight>(scenes[0].areaLights[0].shape);
    EXPECT_EQ(wall.contours.front()[0], glm::vec3(4.0f, 0.5f, -6.0f));
    EXPECT_EQ(wall.contours.front()[2], glm::vec3(-4.0f, 3.5f, -6.0f));
    const glm::mat4& camera = scenes[0].cameras[0].worldFromCamera;
    EXPECT_NEAR(camera[3].z, 10.0f, 1e-5f);
    EXPECT_LT(-camera[2].z, -0.9f);  // Looks along -z, down a little.
}

TEST(ShapeScenes, haveOneLightEachOfEveryShape) {
    std::set<std::string> names;
    std::set<std::size_t> shapes;
    int filmCount = 0, holeCount = 0, twoSidedCount = 0, quickCount = 0;
    for (const ShapeCase& shown : shapeCases(0.2)) {
        EXPECT_TRUE(names.insert(shown.name).second) << shown.name;
        quickCount += shown.shownQuick;
        ASSERT_EQ(shown.scene.areaLights.size(), 1u);
        shapes.insert(shown.scene.areaLights[0].shape.index());
        const auto* light = std::get_if<PolygonLight>(&shown.scene.areaLights[0].shape);
        if (light == nullptr) continue;
        filmCount += light->texture.has_value();
        twoSidedCount += light->twoSided;
        if (light->twoSided) continue;
        for (std::size_t i = 0; i < light->contours.size(); ++i) {
            // Outlines turn toward the floor in front, holes the other way.
            const double turn = areaVector(light->contours[i]).z;
            EXPECT_TRUE(i == 0 ? turn > 0.0 : turn < 0.0) << shown.name;
            holeCount += i > 0;
        }
    }
    EXPECT_EQ(shapes.size(), 4u);
    EXPECT_EQ(filmCount, 3);
    EXPECT_EQ(holeCount, 1);
    EXPECT_EQ(twoSidedCount, 1);
    EXPECT_GE(quickCount, 3);
}

TEST(ShapeScenes, picturesAreUprightAndOfFactorsUpToOne) {
    for (const ShapeCase& shown : shapeCases(0.2)) {
        const auto* light = std::get_if<PolygonLight>(&shown.scene.areaLights[0].shape);
        if (light == nullptr || !light->texture) continue;
        const LightTexture& texture = *light->texture;
        // From the floor in front, that is from +z: the first corner is the lower left one.
        const std::vector<glm::vec3>& corners = light->contours.front();
        const glm::dvec2 expected[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            const glm::dvec2 found = textureCoordinates(texture, glm::dvec3(corners[i]));
            EXPECT_LT(glm::distance(found, expected[i]), 1e-12) << shown.name << " " << i;
        }
        glm::vec3 low(1.0f), high(0.0f);
        for (const glm::vec3& texel : texture.image->texels) {
            low = glm::min(low, texel);
            high = glm::max(high, texel);
        }
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(low, glm::vec3(0.0f)))) << shown.name;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(high, glm::vec3(1.0f)))) << shown.name;
        // None is even.
        EXPECT_TRUE(glm::all(glm::greaterThan(high - low, glm::vec3(0.2f)))) << shown.name;
    }
}

TEST(DivergingColor, isBlueBelowRedAboveAndEquallyStrong) {
    const Color blue = divergingColor(-1.0);
    const Color red = divergingColor(1.0);
    EXPECT_GT(blue[2], blue[0] + 80);
    EXPECT_GT(red[0], red[2] + 80);
    EXPECT_GT(lightness(divergingColor(0.0)), 94.0);
    for (const double value : {0.25, 0.5, 0.75}) {
        // Colours cut off at the border of sRGB turn a little darker.
        EXPECT_NEAR(lightness(divergingColor(value)), 96.0 - 60.0 * value, 3.0);
        EXPECT_NEAR(lightness(divergingColor(-value)), 96.0 - 60.0 * value, 3.0);
    }
    EXPECT_EQ(divergingColor(5.0), red);
}

}  // namespace
}  // namespace polylume::figures
