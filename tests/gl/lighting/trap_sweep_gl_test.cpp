// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <random>

#include "gl/support/gl_test.hpp"
#include "shading_harness.hpp"

namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 512;      // 262,144 points a frame.
constexpr int kFrameCount = 6;  // 1.5 million points.
constexpr int kLightCount = 12;

/// Points and lights on a grid of quarters, where everything that can coincide does: points on
/// planes, edges and vertices of lights, lights on the horizon, views along the normal.
class TrapSweep {
  public:
    explicit TrapSweep(unsigned seed) : generator_(seed) {}

    std::vector<ShadingPoint> makePoints(int count) {
        std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
        for (ShadingPoint& point : points) {
            point.normalWorld = makeNormal();
            point.distance = 0.25f * static_cast<float>(pick(1, 32));
            point.roughness =
                pick(0, 3) == 0 ? static_cast<float>(pick(0, 1)) : uniform(0.0f, 1.0f);
            point.f0 = glm::vec3(uniform(0.0f, 1.0f));
        }
        return points;
    }

    LightSet makeLights() {
        LightSet lights;
        for (int i = 0; i < kLightCount; ++i) {
            PolygonLight light;
            light.contours = {makeContour()};
            light.radiance = glm::vec3(pick(0, 4) == 0 ? 1e8f : 100.0f);
            light.twoSided = pick(0, 1) == 0;
            lights.polygons.push_back(light);
        }
        for (const PunctualLightKind kind :
             {PunctualLightKind::directional, PunctualLightKind::point, PunctualLightKind::spot}) {
            PunctualLight light;
            light.kind = kind;
            light.position = gridPoint();
            light.range = pick(0, 1) == 0 ? INFINITY : 2.0f;
            light.innerConeAngle = light.outerConeAngle = 0.5f;
            lights.punctuals.push_back(light);
        }
        return lights;
    }

  private:
    int pick(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(generator_);
    }
    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }

    glm::vec3 makeNormal() {
        switch (pick(0, 5)) {
            case 0:
                return {0, 0, 1};  // Along the view.
            case 1:
                return {0, 0, -1};  // Away from it.
            case 2:                 // At right angles to it.
                return pick(0, 1) == 0 ? glm::vec3(1, 0, 0) : glm::vec3(0, -1, 0);
            case 3:  // A hair off the view and off the horizon.
                return glm::normalize(glm::vec3(1e-6f, 0, pick(0, 1) == 0 ? 1.0f : 1e-6f));
            default:
                return glm::normalize(glm::vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)) +
                                      glm::vec3(0, 0, 1e-3f));
        }
    }

    /// Half of the pixel centres lie on such points.
    glm::vec3 gridPoint() {
        const float half = 0.5f / 64.0f;
        return {0.25f * static_cast<float>(pick(-16, 16)) + half,
                0.25f * static_cast<float>(pick(-16, 16)) + half,
                -0.25f * static_cast<float>(pick(0, 32))};
    }

    std::vector<glm::vec3> makeContour() {
        const glm::vec3 corner = gridPoint();
        glm::vec3 x(0.0f);
        glm::vec3 y(0.0f);
        const int axis = pick(0, 2);
        x[axis] = 0.25f * static_cast<float>(pick(1, 16));
        y[(axis + 1 + pick(0, 1)) % 3] = 0.25f * static_cast<float>(pick(1, 16));
        switch (pick(0, 7)) {
            case 0:
                y *= 1e-6f;  // Needle-thin.
                break;
            case 1:
                x *= 1e-6f, y *= 1e-6f;  // A speck.
                break;
            case 2:
                x *= 1e5f, y *= 1e5f;  // Covers the horizon.
                break;
            case 3:
                return {corner + 1e5f * x, corner + 1e5f * x + y,
                        corner + 1e5f * x + y + x};  // Far.
            case 4:
                return {corner, corner + x, corner + x + y};
            case 5:  // Concave, with a vertex on an edge's line.
                return {corner, corner + x, corner + x + y, corner + 0.5f * x + 0.5f * y,
                        corner + y};
            default:
                break;
        }
        return {corner, corner + x, corner + x + y, corner + y};
    }

    std::mt19937 generator_;
};

class TrapSweepTest : public test::GlTest {};

TEST_P(TrapSweepTest, everyValueIsFiniteAndNotNegative) {
    const gl::ShaderLibrary library;
    LightingPass lighting(gl(), library, ltc::Table::builtinGgx());
    ShadingHarness harness(gl(), kSize);
    TrapSweep sweep(2026);
    long lit = 0;
    for (int frame = 0; frame < kFrameCount; ++frame) {
        harness.setPoints(sweep.makePoints(harness.pointCount()));
        lighting.setLights(sweep.makeLights());
        for (const glm::vec4& radiance : harness.shade(lighting)) {
            for (int c = 0; c < 3; ++c)
                ASSERT_TRUE(std::isfinite(radiance[c]) && radiance[c] >= 0.0f) << radiance[c];
            lit += radiance.x > 0.0f;
        }
    }
    EXPECT_GT(lit, 100'000) << "the sweep has to light something";
}

POLYLUME_ON_EVERY_BACKEND(TrapSweepTest);

}  // namespace
}  // namespace polylume
