// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <functional>

#include "gl/support/gl_test.hpp"
#include "lights/lighting_model_names.hpp"
#include "ltc/builtin_table.hpp"
#include "shading_harness.hpp"

// A light that moves in small steps toward, across and through a surface: what each step changes is
// what it changes in double precision, so nothing pops.
namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 8;
constexpr int kStepCount = 1000;
/// Of the light's luminance, per step; the limit.
constexpr double kLargestDifference = 1e-3;

/// A light and its evaluation in double at a point: diffuse and specular factor, both at full
/// reflection.
struct MovingLight {
    std::function<LightSet(const glm::vec3& offset)> place;
    std::function<glm::dvec2(const SurfacePixel& pixel, const LightSet& lights)> shadeInDouble;
};

/// Diffuse and specular factor of a light, by its integrals in double.
template <typename Light>
glm::dvec2 factorsOf(const SurfacePixel& pixel, const Light& light) {
    const test::ReferenceShading shading =
        test::shadeInDouble(pixel, light, ltc::builtinTable(ltc::BuiltinTable::ggx));
    return {shading.diffuse, shading.albedo * shading.specular};
}

/// Of radiance 1, facing the points from z = 0 if `tilt` is 0; with 1 it stands on their surface.
MovingLight movingPolygon(const std::vector<std::vector<glm::vec2>>& contours, float tilt) {
    MovingLight light;
    light.place = [=](const glm::vec3& offset) {
        PolygonLight polygon;
        for (const auto& contour : contours) {
            auto& placed = polygon.contours.emplace_back();
            for (const glm::vec2& p : contour) {
                // Counter-clockwise seen from -z.
                const glm::vec3 flat(p.y, p.x, 0.0f);
                const glm::vec3 upright(0.4f, p.y, p.x);
                placed.push_back(offset + glm::mix(flat, upright, tilt));
            }
        }
        polygon.radiance = glm::vec3(1.0f);
        LightSet lights;
        lights.polygons.push_back(polygon);
        return lights;
    };
    light.shadeInDouble = [](const SurfacePixel& pixel, const LightSet& lights) {
        return factorsOf(pixel, lights.polygons.front());
    };
    return light;
}

/// As movingPolygon(), from the half axes of an ellipse.
MovingLight movingEllipse(const glm::vec2& halfAxes, float tilt) {
    MovingLight light;
    light.place = [=](const glm::vec3& offset) {
        EllipseLight ellipse;
        // No step brings its plane to a point but for rounding.
        const glm::vec3 normal =
            glm::normalize(glm::mix(glm::vec3(0, 0, -1), {-1, 0.17f, 0}, tilt));
        const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal));
        ellipse.center = offset + glm::vec3(0.4f * tilt, 0.0f, 0.0f);
        ellipse.halfAxisX = halfAxes.x * x;
        ellipse.halfAxisY = halfAxes.y * glm::cross(normal, x);
        ellipse.radiance = glm::vec3(1.0f);
        return LightSet{{}, {}, {ellipse}};
    };
    light.shadeInDouble = [](const SurfacePixel& pixel, const LightSet& lights) {
        return factorsOf(pixel, lights.ellipses.front());
    };
    return light;
}

MovingLight movingSphere(float radius) {
    MovingLight light;
    light.place = [=](const glm::vec3& offset) {
        return LightSet{{}, {}, {}, {{offset, radius, glm::vec3(1.0f), false}}};
    };
    light.shadeInDouble = [](const SurfacePixel& pixel, const LightSet& lights) {
        return factorsOf(pixel, lights.spheres.front());
    };
    return light;
}

const std::vector<glm::vec2> kTriangle = {{-0.5f, -0.4f}, {0.5f, -0.3f}, {0.1f, 0.5f}};
const std::vector<glm::vec2> kRectangle = {
    {-0.5f, -0.4f}, {0.5f, -0.4f}, {0.5f, 0.4f}, {-0.5f, 0.4f}};
const std::vector<glm::vec2> kHexagon = {{0.5f, 0},  {0.25f, 0.4f},   {-0.25f, 0.4f},
                                         {-0.5f, 0}, {-0.25f, -0.4f}, {0.25f, -0.4f}};
const std::vector<glm::vec2> kStar = {{0.6f, 0},  {0.1f, 0.1f},   {0, 0.6f},  {-0.1f, 0.1f},
                                      {-0.6f, 0}, {-0.1f, -0.1f}, {0, -0.6f}, {0.1f, -0.1f}};
const std::vector<glm::vec2> kHole = {{0, 0.1f}, {0.1f, 0}, {0, -0.1f}, {-0.1f, 0}};

struct Path {
    const char* name;
    glm::vec3 from;
    glm::vec3 to;
    float tilt;
    /// Whether the points pass the plane of the light, where a one-sided light jumps.
    bool passesPlane;
};

// The points lie at z = -4, within 0.06 of the axis.
const Path kPaths[] = {
    {"toward", {0.1f, 0.2f, -1}, {0.1f, 0.2f, -3.99f}, 0.0f, false},
    {"toward, to its edge", {0.45f, 0.35f, -1}, {0.45f, 0.35f, -3.999f}, 0.0f, false},
    {"across", {-2, 0.1f, -3.5f}, {2, 0.1f, -3.5f}, 0.0f, false},
    {"through, lying", {0.1f, 0.05f, -3.5f}, {0.1f, 0.05f, -4.5f}, 0.0f, true},
    {"through, upright", {0.1f, 0.05f, -2.5f}, {0.1f, 0.05f, -5.5f}, 1.0f, false},
    {"through, upright, past the points", {-1.5f, 0.05f, -3.9f}, {1.5f, 0.05f, -4.1f}, 1.0f, true},
    {"through, leaning", {0.3f, -0.2f, -2.5f}, {0.3f, 0.2f, -5.5f}, 0.6f, true},
};

class ContinuityTest : public test::GlTest {
  protected:
    /// One point for each pair of a roughness and a tilt of the normal.
    static std::vector<ShadingPoint> makePoints(Lobes lobes) {
        std::vector<ShadingPoint> points;
        for (int i = 0; i < kSize * kSize; ++i) {
            ShadingPoint point;
            const float tilt = 0.15f * static_cast<float>(i % kSize);
            point.normalWorld = glm::normalize(glm::vec3(tilt, 0.3f * tilt, 1.0f));
            point.distance = 4.0f;
            point.roughness = std::max(0.05f, static_cast<float>(i / kSize) / (kSize - 1.0f));
            points.push_back(point);
        }
        test::reflectOnly(lobes, points);
        return points;
    }

    /// What remains of the light's plane passing a point: true in double, too.
    static bool isJump(const Path& path, double before, double after) {
        return path.passesPlane && (before == 0.0) != (after == 0.0);
    }

    /// The largest difference between what a step changes and what it changes in double.
    double largestDifference(const MovingLight& light, const Path& path, Lobes lobes,
                             float twist = 0.0f) {
        const gl::ShaderLibrary library;
        LightingPass lighting(gl(), library);
        lighting.setLobes(lobes);
        ShadingHarness harness(gl(), kSize);
        harness.setPoints(makePoints(lobes));
        const std::vector<SurfacePixel> pixels = harness.decoded();
        std::vector<double> shaded(pixels.size()), expected(pixels.size());
        double largest = 0.0;
        double brightest = 0.0;
        for (int step = 0; step <= kStepCount; ++step) {
            const float share = static_cast<float>(step) / kStepCount;
            const LightSet lights = light.place(glm::mix(path.from, path.to, share));
            lighting.setLights(lights);
            const std::vector<glm::vec4> radiance = harness.shade(lighting);
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const glm::dvec2 factors = light.shadeInDouble(pixels[i], lights);
                const double next = lobes == Lobes::diffuse ? factors.x : factors.y;
                const double value = radiance[i].x + (step == kStepCount / 2 ? twist : 0.0f);
                if (step > 0 && !isJump(path, expected[i], next)) {
                    const double change = (value - shaded[i]) - (next - expected[i]);
                    largest = std::max(largest, std::abs(change));
                }
                brightest = std::max(brightest, next);
                shaded[i] = value;
                expected[i] = next;
            }
        }
        EXPECT_GT(brightest, 0.05) << path.name;
        return largest;
    }

    void expectContinuous(const std::vector<std::vector<glm::vec2>>& contours) {
        expectContinuous([&](float tilt) { return movingPolygon(contours, tilt); });
    }

    void expectContinuous(const std::function<MovingLight(float tilt)>& makeLight) {
        for (const Path& path : kPaths) {
            const MovingLight light = makeLight(path.tilt);
            for (const Lobes lobes : {Lobes::diffuse, Lobes::specular}) {
                const double difference = largestDifference(light, path, lobes);
                RecordProperty(std::string(path.name) + ", " + nameOf(lobes),
                               std::to_string(difference));
                EXPECT_LT(difference, kLargestDifference) << path.name << ", " << nameOf(lobes);
            }
        }
    }
};

TEST_P(ContinuityTest, triangle) {
    expectContinuous({kTriangle});
}
TEST_P(ContinuityTest, rectangle) {
    expectContinuous({kRectangle});
}
TEST_P(ContinuityTest, hexagon) {
    expectContinuous({kHexagon});
}
TEST_P(ContinuityTest, starWithAHole) {
    expectContinuous({kStar, kHole});
}

TEST_P(ContinuityTest, disk) {
    expectContinuous([](float tilt) { return movingEllipse({0.5f, 0.5f}, tilt); });
}
TEST_P(ContinuityTest, ellipse) {
    expectContinuous([](float tilt) { return movingEllipse({0.6f, 0.3f}, tilt); });
}
TEST_P(ContinuityTest, sphere) {
    expectContinuous([](float) { return movingSphere(0.4f); });
}

TEST_P(ContinuityTest, stepThatPopsIsSeen) {
    const MovingLight light = movingPolygon({kHexagon}, 0.0f);
    EXPECT_GT(largestDifference(light, kPaths[2], Lobes::diffuse, 2e-3f), kLargestDifference);
}

POLYLUME_ON_EVERY_BACKEND(ContinuityTest);

}  // namespace
}  // namespace polylume
