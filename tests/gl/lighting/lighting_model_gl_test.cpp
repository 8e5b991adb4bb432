// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "polylume/lighting_model.hpp"

#include <gmock/gmock.h>

#include <random>

#include "gl/support/gl_test.hpp"
#include "ltc/builtin_table.hpp"
#include "shading_harness.hpp"

namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 96;  // 9,216 points a frame.

const LightingModel kModels[] = {
    {.quality = Quality::high},
    {.specular = Specular::beckmann},
    {.specular = Specular::beckmann, .quality = Quality::high},
    {.diffuse = Diffuse::burley},
    {.diffuse = Diffuse::orenNayar, .quality = Quality::high},
    {.sheen = true},
    {.diffuse = Diffuse::burley, .quality = Quality::high, .sheen = true},
};

std::string describe(const LightingModel& model) {
    constexpr const char* kDiffuses[] = {"lambert", "burley", "oren-nayar"};
    return std::string(model.specular == Specular::beckmann ? "beckmann " : "ggx ") +
           kDiffuses[static_cast<int>(model.diffuse)] +
           (model.quality == Quality::high ? " high" : "") + (model.sheen ? " sheen" : "");
}

/// A rectangle before the points that faces them and cuts some of their horizons; with
/// `asPolygon`, of five vertices.
PolygonLight makeLight(bool asPolygon) {
    PolygonLight light;
    light.contours = {{{-1, -1, 0}, {-1, 1, 0}, {2, 1, -5}, {2, -1, -5}}};
    if (asPolygon) light.contours.front().insert(light.contours.front().begin() + 1, {-1, 0, 0});
    light.radiance = {10.0f, 7.0f, 2.0f};
    return light;
}

std::vector<ShadingPoint> makePoints(int count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto color = [&] {
        return glm::vec3(uniform(generator), uniform(generator), uniform(generator));
    };
    std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
    for (ShadingPoint& point : points) {
        point.normalWorld = glm::normalize(2.0f * color() - 1.0f + glm::vec3(0, 0, 0.7f));
        point.distance = 4.0f + uniform(generator);
        point.roughness = 0.05f + 0.95f * uniform(generator);
        point.diffuseAlbedo = color();
        point.f0 = color();
        // Every other surface is without.
        if (uniform(generator) < 0.5f) point.sheenColor = color();
        point.sheenRoughness = uniform(generator);
    }
    return points;
}

class LightingModelTest : public test::GlTest {
  protected:
    struct Shaded {
        std::vector<glm::vec4> radiance;
        std::vector<SurfacePixel> pixels;
    };

    Shaded shade(const LightingModel& model, const LightSet& lights,
                 const std::vector<ShadingPoint>& points, Lobes lobes = Lobes::all) {
        const gl::ShaderLibrary library;
        LightingPass lighting(gl(), library, model);
        lighting.setLights(lights);
        lighting.setLobes(lobes);
        ShadingHarness harness(gl(), kSize, model.sheen);
        harness.setPoints(points);
        return {harness.shade(lighting), harness.decoded()};
    }

    /// The largest difference to double precision, with `claimed` taken for the model, as a
    /// fraction of the largest value.
    static double largestError(const Shaded& shaded, const PolygonLight& light,
                               const LightingModel& claimed) {
        double largest = 0.0;
        double error = 0.0;
        for (std::size_t i = 0; i < shaded.radiance.size(); ++i) {
            const glm::dvec3 expected = test::reflectInDouble(shaded.pixels[i], light, claimed);
            for (int c = 0; c < 3; ++c) {
                largest = std::max(largest, expected[c]);
                const double difference = std::abs(shaded.radiance[i][c] - expected[c]);
                error = std::isfinite(difference) ? std::max(error, difference) : INFINITY;
            }
        }
        EXPECT_GT(largest, 1.0);
        return error / largest;
    }
};

TEST_P(LightingModelTest, everyModelEqualsDoublePrecision) {
    const std::vector<ShadingPoint> points = makePoints(kSize * kSize, 31);
    for (const LightingModel& model : kModels) {
        for (const bool asPolygon : {false, true}) {
            const PolygonLight light = makeLight(asPolygon);
            const double error = largestError(shade(model, {{light}, {}}, points), light, model);
            RecordProperty(describe(model), std::to_string(error));
            // As for one lobe: float places the edge of the smoothest lobe that well.
            EXPECT_LT(error, 1e-4) << describe(model) << (asPolygon ? " polygon" : "");
        }
    }
}

TEST_P(LightingModelTest, theComparisonTellsEveryModelFromTheDefault) {
    const std::vector<ShadingPoint> points = makePoints(kSize * kSize, 31);
    const PolygonLight light = makeLight(false);
    for (const LightingModel& model : kModels) {
        const Shaded shaded = shade(model, {{light}, {}}, points);
        EXPECT_GT(largestError(shaded, light, {}), 1e-2) << describe(model);
    }
}

TEST_P(LightingModelTest, lobesAddUp) {
    const LightingModel model{
        .diffuse = Diffuse::orenNayar, .quality = Quality::high, .sheen = true};
    const std::vector<ShadingPoint> points = makePoints(kSize * kSize, 5);
    PunctualLight lamp;
    lamp.position = {1, 1, 2};
    lamp.intensity = glm::vec3(30.0f);
    const LightSet lights{{makeLight(false), makeLight(true)}, {lamp}};
    const Shaded all = shade(model, lights, points);
    const Shaded diffuse = shade(model, lights, points, Lobes::diffuse);
    const Shaded specular = shade(model, lights, points, Lobes::specular);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float sum = diffuse.radiance[i].x + specular.radiance[i].x;
        ASSERT_NEAR(all.radiance[i].x, sum, 1e-6f * (1.0f + sum)) << i;
    }
}

TEST_P(LightingModelTest, surfaceWithoutSheenLooksAsInASceneWithout) {
    const PolygonLight light = makeLight(false);
    std::vector<ShadingPoint> points = makePoints(kSize * kSize, 8);
    const Shaded with = shade({.sheen = true}, {{light}, {}}, points);
    const Shaded without = shade({}, {{light}, {}}, points);
    std::size_t differentCount = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float difference = std::abs(with.radiance[i].x - without.radiance[i].x);
        if (points[with.pixels.size() - 1 - i].sheenColor == glm::vec3(0.0f)) continue;
        differentCount += difference > 1e-3f;
    }
    EXPECT_GT(differentCount, points.size() / 10);
    for (ShadingPoint& point : points) point.sheenColor = glm::vec3(0.0f);
    const Shaded bare = shade({.sheen = true}, {{light}, {}}, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        // The compiler may order the sums differently.
        ASSERT_NEAR(bare.radiance[i].x, without.radiance[i].x, 1e-5f) << i;
    }
}

TEST_P(LightingModelTest, nothingReflectsMoreThanItReceives) {
    // A sheet of radiance 1 that covers the hemisphere, white surfaces of every kind under it.
    // Burley and Oren-Nayar have an excess of their own (engine/brdf).
    std::vector<ShadingPoint> points = makePoints(kSize * kSize, 17);
    for (ShadingPoint& point : points) {
        point.normalWorld = {0.6f, 0.0f, 0.8f};
        point.diffuseAlbedo = glm::vec3(1.0f);
        point.f0 = glm::vec3(point.roughness > 0.5f ? 1.0f : 0.04f);
        if (point.sheenColor != glm::vec3(0.0f)) point.sheenColor = glm::vec3(1.0f);
    }
    // Views from the normal to a hair above the surface.
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float angle = 1.5706f * static_cast<float>(i % kSize) / (kSize - 1);
        points[i].normalWorld = {std::sin(angle), 0.0f, std::cos(angle)};
    }
    PolygonLight sheet;
    constexpr float kFar = 1e5f;
    for (const Quality quality : {Quality::standard, Quality::high}) {
        for (const bool sheen : {false, true}) {
            float largest = 0.0f;
            float smallest = 2.0f;
            // A box of six sides around all points.
            LightSet box;
            for (int axis = 0; axis < 3; ++axis) {
                for (const float side : {-1.0f, 1.0f}) {
                    glm::vec3 u(0.0f), v(0.0f), center(0.0f);
                    center[axis] = side * kFar;
                    u[(axis + 1) % 3] = kFar;
                    v[(axis + 2) % 3] = side * -kFar;
                    sheet.contours = {
                        {center - u - v, center + u - v, center + u + v, center - u + v}};
                    sheet.radiance = glm::vec3(1.0f);
                    box.polygons.push_back(sheet);
                }
            }
            const Shaded shaded = shade({.quality = quality, .sheen = sheen}, box, points);
            for (const glm::vec4& radiance : shaded.radiance) {
                largest = std::max(largest, radiance.x);
                smallest = std::min(smallest, radiance.x);
            }
            // Six sums of float over edges that are as far apart as they are away.
            EXPECT_LT(largest, 1.0f + 2e-3f) << (sheen ? "sheen" : "");
            EXPECT_GT(smallest, 0.2f);
        }
    }
}

POLYLUME_ON_EVERY_BACKEND(LightingModelTest);

}  // namespace
}  // namespace polylume
