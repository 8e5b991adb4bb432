// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <functional>
#include <random>

#include "gl/support/gl_test.hpp"
#include "ltc/builtin_table.hpp"
#include "shading_harness.hpp"

// Ellipses, spheres and tubes against their integrals in double.
namespace polylume {
namespace {

using test::ReferenceShading;
using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 64;

/// Points of an even distance whose normals and views make all angles up to grazing ones.
std::vector<ShadingPoint> makePoints(int count, float roughness, float distance) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
    for (ShadingPoint& point : points) {
        point.normalWorld = glm::normalize(glm::vec3(uniform(generator), uniform(generator), 0.0f) +
                                           glm::vec3(0, 0, 0.15f + std::abs(uniform(generator))));
        point.distance = distance + 0.5f * uniform(generator);
        point.roughness = roughness;
    }
    return points;
}

struct Errors {
    double absolute = 0.0;  ///< Largest difference of a form factor.
    double relative = 0.0;  ///< Over the largest value of the picture.
};

class RoundLightTest : public test::GlTest {
  protected:
    template <typename Light>
    static LightSet setOf(const Light& light) {
        LightSet lights;
        if constexpr (std::is_same_v<Light, EllipseLight>) lights.ellipses = {light};
        if constexpr (std::is_same_v<Light, SphereLight>) lights.spheres = {light};
        if constexpr (std::is_same_v<Light, TubeLight>) lights.tubes = {light};
        return lights;
    }

    template <typename Light>
    Errors errorsOf(Light light, float roughness, Lobes lobes, float distance = 7.0f) {
        light.radiance = glm::vec3(1.0f);
        const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
        const gl::ShaderLibrary library;
        LightingPass lighting(gl(), library, table);
        lighting.setLobes(lobes);
        lighting.setLights(setOf(light));
        ShadingHarness harness(gl(), kSize);
        std::vector<ShadingPoint> points = makePoints(harness.pointCount(), roughness, distance);
        test::reflectOnly(lobes, points);
        harness.setPoints(points);
        const std::vector<glm::vec4> shaded = harness.shade(lighting);
        const std::vector<SurfacePixel> decoded = harness.decoded();
        Errors errors;
        double largest = 0.0;
        for (std::size_t i = 0; i < shaded.size(); ++i) {
            const ReferenceShading reference = test::shadeInDouble(decoded[i], light, table);
            const double expected =
                lobes == Lobes::diffuse ? reference.diffuse : reference.albedo * reference.specular;
            largest = std::max(largest, expected);
            errors.absolute = std::max(errors.absolute, std::abs(shaded[i].x - expected));
        }
        errors.relative = errors.absolute / largest;
        EXPECT_GT(largest, 0.0);
        return errors;
    }
};

EllipseLight makeEllipse(const glm::vec3& center, const glm::vec3& x, const glm::vec3& y) {
    return {center, x, y, glm::vec3(1.0f), true};
}

const EllipseLight kDisk = makeEllipse({0.2f, 0.1f, 0}, {0, 1, 0}, {1, 0, 0});
const EllipseLight kEllipse = makeEllipse({-0.5f, 0.3f, -1}, {0.3f, 1.5f, 0}, {0.2f, -0.04f, 0.3f});
const SphereLight kSphere{{0.5f, -0.3f, -2}, 0.8f, glm::vec3(1.0f), false};
const TubeLight kTube{{-1.5f, -0.5f, -3}, {1.5f, 1, 0}, 0.2f, glm::vec3(1.0f), false};
/// The horizon of every point passes through these.
const EllipseLight kSunkDisk = makeEllipse({0, 1, -7}, {0, 0, 2}, {2, 0, 0});
const SphereLight kSunkSphere{{1.5f, 1.5f, -7}, 1.0f, glm::vec3(1.0f), false};
const TubeLight kSunkTube{{2, 0.5f, -9}, {-2, 1.5f, -5}, 0.4f, glm::vec3(1.0f), false};

TEST_P(RoundLightTest, diffuseEqualsDoublePrecision) {
    // The rounding of positions and of the sum.
    constexpr double kTolerance = 3e-6;
    EXPECT_LT(errorsOf(kDisk, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kEllipse, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kSphere, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kTube, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kSunkDisk, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kSunkSphere, 0.5f, Lobes::diffuse).absolute, kTolerance);
    EXPECT_LT(errorsOf(kSunkTube, 0.5f, Lobes::diffuse).absolute, kTolerance);
}

TEST_P(RoundLightTest, specularEqualsDoublePrecision) {
    for (const float roughness : {0.02f, 0.05f, 0.1f, 0.3f, 0.6f, 1.0f}) {
        // As for rectangles: smooth lobes magnify the rounding of positions.
        const double tolerance = roughness < 0.2f ? 2e-4 : 1e-5;
        const auto check = [&](const char* name, const auto& light) {
            const Errors errors = errorsOf(light, roughness, Lobes::specular);
            RecordProperty(name + std::to_string(roughness), std::to_string(errors.absolute));
            EXPECT_LT(errors.absolute, tolerance) << name << ", roughness " << roughness;
        };
        check("disk ", kDisk);
        check("ellipse ", kEllipse);
        check("sphere ", kSphere);
        check("tube ", kTube);
        check("sunk disk ", kSunkDisk);
        check("sunk sphere ", kSunkSphere);
        check("sunk tube ", kSunkTube);
    }
}

TEST_P(RoundLightTest, smallLightKeepsItsDigits) {
    EllipseLight disk = kDisk;
    disk.halfAxisX *= 1e-4f;
    disk.halfAxisY *= 1e-4f;
    SphereLight sphere = kSphere;
    sphere.radius = 1e-4f;
    TubeLight speck = kTube;
    speck.radius = 1e-4f;
    speck.end = speck.start + glm::vec3(1e-4f, 0, 1e-4f);
    for (const Lobes lobes : {Lobes::diffuse, Lobes::specular}) {
        EXPECT_LT(errorsOf(disk, 0.3f, lobes).relative, 1e-3);
        EXPECT_LT(errorsOf(sphere, 0.3f, lobes).relative, 1e-3);
        EXPECT_LT(errorsOf(speck, 0.3f, lobes).relative, 1e-3);
    }
}

TEST_P(RoundLightTest, thinTubeKeepsItsDigits) {
    TubeLight line = kTube;
    for (const float radius : {0.1f, 0.05f, 0.03f, 1e-2f, 1e-3f, 1e-4f, 1e-5f}) {
        line.radius = radius;
        EXPECT_LT(errorsOf(line, 0.5f, Lobes::diffuse).relative, 1e-3) << radius;
        EXPECT_LT(errorsOf(line, 0.3f, Lobes::specular).relative, 1e-3) << radius;
        EXPECT_LT(errorsOf(line, 0.1f, Lobes::specular).relative, 1e-3) << radius;
        TubeLight sunk = kSunkTube;
        sunk.radius = radius;
        EXPECT_LT(errorsOf(sunk, 0.3f, Lobes::specular).relative, 1e-3) << radius;
    }
}

TEST_P(RoundLightTest, oneSidedEllipseLightsItsSideOnly) {
    EllipseLight disk = kDisk;
    disk.twoSided = false;
    disk.halfAxisY = -disk.halfAxisY;
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library);
    ShadingHarness harness(gl(), kSize);
    harness.setPoints(makePoints(harness.pointCount(), 0.3f, 7.0f));
    lighting.setLights(setOf(disk));
    for (const glm::vec4& radiance : harness.shade(lighting)) ASSERT_EQ(radiance.x, 0.0f);
}

TEST_P(RoundLightTest, pointInsideIsLitByATwoSidedLightAlone) {
    SphereLight sphere{{0, 0, -7}, 5.0f, glm::vec3(1.0f), false};
    TubeLight tube{{-1, 0, -7}, {1, 0, -7}, 5.0f, glm::vec3(1.0f), false};
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library);
    ShadingHarness harness(gl(), kSize);
    std::vector<ShadingPoint> points = makePoints(harness.pointCount(), 0.3f, 7.0f);
    for (ShadingPoint& point : points) {
        point.diffuseAlbedo = glm::vec3(1.0f);
        point.f0 = glm::vec3(0.0f);
        point.f90 = 0.0f;
    }
    harness.setPoints(points);
    for (const bool twoSided : {false, true}) {
        sphere.twoSided = tube.twoSided = twoSided;
        for (const LightSet& lights : {setOf(sphere), setOf(tube)}) {
            lighting.setLights(lights);
            for (const glm::vec4& radiance : harness.shade(lighting)) {
                ASSERT_NEAR(radiance.x, twoSided ? 1.0f : 0.0f, 1e-6f);
            }
        }
    }
}

/// A light moving through the points' horizons and past them: each step changes what it gives by as
/// much as in double.
template <typename Light>
double largestJump(const gl::Functions& gl, const std::function<Light(float)>& at,
                   float roughness) {
    constexpr int kStepCount = 1000;
    const ltc::Table& table = ltc::builtinTable(ltc::BuiltinTable::ggx);
    const gl::ShaderLibrary library;
    LightingPass lighting(gl, library, table);
    lighting.setLobes(Lobes::specular);
    ShadingHarness harness(gl, 4);
    std::vector<ShadingPoint> points = makePoints(harness.pointCount(), roughness, 7.0f);
    for (ShadingPoint& point : points) {
        point.diffuseAlbedo = glm::vec3(0.0f);
        point.f0 = glm::vec3(1.0f);
    }
    harness.setPoints(points);
    const std::vector<SurfacePixel> decoded = harness.decoded();
    std::vector<double> last;
    double largest = 0.0;
    for (int step = 0; step <= kStepCount; ++step) {
        const Light light = at(static_cast<float>(step) / kStepCount);
        LightSet lights;
        if constexpr (std::is_same_v<Light, EllipseLight>) lights.ellipses = {light};
        if constexpr (std::is_same_v<Light, SphereLight>) lights.spheres = {light};
        if constexpr (std::is_same_v<Light, TubeLight>) lights.tubes = {light};
        lighting.setLights(lights);
        const std::vector<glm::vec4> shaded = harness.shade(lighting);
        std::vector<double> errors;
        for (std::size_t i = 0; i < shaded.size(); ++i) {
            const ReferenceShading reference = test::shadeInDouble(decoded[i], light, table);
            errors.push_back(shaded[i].x - reference.albedo * reference.specular);
            if (!last.empty()) largest = std::max(largest, std::abs(errors[i] - last[i]));
        }
        last = errors;
    }
    return largest;
}

TEST_P(RoundLightTest, movingLightNeverPops) {
    for (const float roughness : {0.05f, 0.4f}) {
        EXPECT_LT(largestJump<EllipseLight>(
                      gl(),
                      [](float t) {
                          EllipseLight light = kSunkDisk;
                          light.center += glm::vec3(0, 0.5f, 6 * t - 3);
                          return light;
                      },
                      roughness),
                  1e-3);
        EXPECT_LT(largestJump<SphereLight>(
                      gl(),
                      [](float t) {
                          SphereLight light = kSunkSphere;
                          light.center.z += 8 * t - 4;
                          return light;
                      },
                      roughness),
                  1e-3);
        EXPECT_LT(largestJump<TubeLight>(
                      gl(),
                      [](float t) {
                          TubeLight light = kSunkTube;
                          light.radius = 0.2f;
                          light.start += glm::vec3(0, 0, 8 * t - 4);
                          light.end += glm::vec3(2 * t, 0, 8 * t - 4);
                          return light;
                      },
                      roughness),
                  1e-3);
    }
}

POLYLUME_ON_EVERY_BACKEND(RoundLightTest);

}  // namespace
}  // namespace polylume
