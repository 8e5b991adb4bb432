// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "gl/support/gl_test.hpp"
#include "shading_harness.hpp"
#include "trap_random.hpp"

namespace polylume {
namespace {

using test::ShadingHarness;
using test::ShadingPoint;

constexpr int kSize = 512;  // 262,144 points a frame.
constexpr int kLightCount = 12;

/// Frames that hold POLYLUME_TRAP_CASES cases, one without it. A case is a point and a light: a
/// frame has three million.
int frameCount() {
    return test::trapFrameCount(double{kLightCount} * kSize * kSize, 1);
}

/// What all lights of a sweep are: each has its own path through the shader, or its own traps.
enum class Shape { rectangle, triangle, convex, concave };
constexpr Shape kShapes[] = {Shape::rectangle, Shape::triangle, Shape::convex, Shape::concave};

const char* nameOf(Shape shape) {
    constexpr const char* kNames[] = {"rectangle", "triangle", "convex", "concave"};
    return kNames[static_cast<int>(shape)];
}

/// Rounding: 7e-6 measured.
constexpr float kRangeTolerance = 5e-5f;
/// Normals that face away from the viewer or lie at right angles to the view stand on the table's
/// last row, where the smoothest lobe that is promised is cut at its peak by the surface: all
/// directions but those around the peak become nearly opposite ones there. 0.09 measured, at a few
/// points in a million; what is lit is clamped.
constexpr float kAvertedRangeTolerance = 0.12f;
constexpr float kAvertedCosine = 1e-3f;
/// The roughness from which the factors are promised to be in range: smoother lobes at grazing
/// views divide by a share of the lobe so small that rounding shows, and lights a hundred thousand
/// times larger than their distance have too few digits near. What is lit stays from 0 to the
/// light's own radiance all the same.
constexpr float kRangeRoughness = 0.05f;

/// A regular polygon in the parallelogram from `corner`, every second vertex `inner` times as far
/// from the middle.
std::vector<glm::vec3> makeRing(const glm::vec3& corner, const glm::vec3& x, const glm::vec3& y,
                                int sides, float inner) {
    std::vector<glm::vec3> contour;
    for (int i = 0; i < sides; ++i) {
        const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(sides);
        const float radius = 0.5f * (i % 2 == 0 ? 1.0f : inner);
        contour.push_back(corner + (0.5f + radius * std::cos(angle)) * x +
                          (0.5f + radius * std::sin(angle)) * y);
    }
    return contour;
}

/// Points and lights on a grid of quarters, where everything that can coincide does: points on
/// planes, edges and vertices of lights, lights on the horizon, views along the normal.
class TrapSweep : test::TrapRandom {
  public:
    /// With `withHuge` some lights reach 1e5 times farther than the points.
    TrapSweep(unsigned seed, bool withHuge, Shape shape)
        : TrapRandom(seed), withHuge_(withHuge), shape_(shape) {}

    std::vector<ShadingPoint> makePoints(int count) {
        std::vector<ShadingPoint> points(static_cast<std::size_t>(count));
        for (ShadingPoint& point : points) {
            point.normalWorld = makeNormal();
            point.distance = 0.25f * static_cast<float>(pick(1, 32));
            point.roughness =
                pick(0, 3) == 0 ? static_cast<float>(pick(0, 1)) : uniform(0.0f, 1.0f);
            point.f0 = glm::vec3(uniform(0.0f, 1.0f));
            if (pick(0, 1) == 0) point.sheenColor = glm::vec3(uniform(0.0f, 1.0f));
            point.sheenRoughness =
                pick(0, 3) == 0 ? static_cast<float>(pick(0, 1)) : uniform(0.0f, 1.0f);
        }
        return points;
    }

    LightSet makeLights() {
        LightSet lights;
        for (int i = 0; i < kLightCount; ++i) {
            PolygonLight light;
            light.contours = {makeContour()};
            if (shape_ == Shape::concave && pick(0, 1) == 0) addHole(light);
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
                if (withHuge_) x *= 1e5f, y *= 1e5f;  // Covers the horizon.
                break;
            case 3:
                if (withHuge_) return outlineOf(corner + 1e5f * x, x, y);  // Far.
                break;
            default:
                break;
        }
        return outlineOf(corner, x, y);
    }

    std::vector<glm::vec3> outlineOf(const glm::vec3& corner, const glm::vec3& x,
                                     const glm::vec3& y) {
        switch (shape_) {
            case Shape::triangle:
                return {corner, corner + x, corner + x + y};
            case Shape::convex:  // On the grid, a vertex in the middle of an edge; or a round one.
                if (pick(0, 1) == 0) {
                    return {corner,
                            corner + 0.5f * x,
                            corner + x,
                            corner + x + 0.5f * y,
                            corner + 0.5f * x + y,
                            corner + y};
                }
                return makeRing(corner, x, y, pick(5, 16), 1.0f);
            case Shape::concave:  // A vertex on an edge's line; or a star.
                if (pick(0, 1) == 0) {
                    return {corner, corner + x, corner + x + y, corner + 0.5f * x + 0.5f * y,
                            corner + y};
                }
                return makeRing(corner, x, y, 2 * pick(3, 8), 0.5f);
            case Shape::rectangle:
                break;
        }
        return {corner, corner + x, corner + x + y, corner + y};
    }

    /// A hole of half the outline's size, turned the other way; sometimes of no size, or as large
    /// as the outline. Stars shrink to their middle, others to their first vertex, which then is
    /// common to both.
    void addHole(PolygonLight& light) {
        const std::vector<glm::vec3>& outline = light.contours.front();
        const float share = 0.5f * static_cast<float>(pick(0, 2));
        const glm::vec3 fixed = outline.size() == 5
                                    ? outline.front()
                                    : 0.5f * (outline.front() + outline[outline.size() / 2]);
        std::vector<glm::vec3> hole;
        for (auto vertex = outline.rbegin(); vertex != outline.rend(); ++vertex) {
            hole.push_back(fixed + share * (*vertex - fixed));
        }
        light.contours.push_back(hole);
    }

    bool withHuge_;
    Shape shape_;
};

/// The form factors themselves, summed over the lights: max() in shadeSurface() would hide a value
/// that is not a number.
constexpr const char* kFactorShader = R"(#include "lighting/shade.glsl"
#include "surface/gbuffer_read.glsl"
layout(location = 0) out vec4 outFactors;

vec4 grown(vec4 sum, vec2 factors) {
    factors *= FACTOR_SCALE;
    return vec4(sum.xy + factors, min(sum.z, min(factors.x, factors.y)), max(sum.w, max(factors.x, factors.y)));
}

void main() {
    Surface surface = readGBuffer(ivec2(gl_FragCoord.xy));
    SurfaceLobes lobes = surfaceLobes(surface);
    SurfaceLobes scaled = flatLobes(lobes);
    vec4 sum = vec4(0.0);
#ifdef POLYLUME_PARALLELOGRAM_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.x; ++i) {
        sum = grown(sum, parallelogramFactors(i, surface.positionWorld, scaled));
    }
#endif
#ifdef POLYLUME_TRIANGLE_LIGHTS
    for (uint i = 0u; i < lighting.lightCount.w; ++i) {
        sum = grown(sum, triangleFactors(i, surface.positionWorld, scaled));
    }
#endif
#ifdef POLYLUME_POLYGON_LIGHTS
    for (uint i = lighting.lightCount.w; i < lighting.lightCount.y; ++i) {
        sum = grown(sum, polygonFactors(i, surface.positionWorld, scaled));
    }
#endif
    outFactors = sum;
}
)";

/// The least and the most of what a shader is made of.
const LightingModel kModels[] = {
    {},
    {.specular = Specular::beckmann,
     .diffuse = Diffuse::burley,
     .quality = Quality::high,
     .sheen = true},
    {.diffuse = Diffuse::orenNayar, .quality = Quality::high, .sheen = true},
};

/// Of the factors of each light, as kFactorShader writes them.
struct Range {
    float lowest = 0.0f;
    float highest = 0.0f;

    void include(const glm::vec4& factors) {
        lowest = std::min(lowest, factors.z);
        highest = std::max(highest, factors.w);
    }
    bool isWithin(float tolerance) const {
        return lowest > -tolerance && highest < 1.0f + tolerance;
    }
    std::string describe() const {
        return " " + std::to_string(lowest) + " to " + std::to_string(highest);
    }
};

class TrapSweepTest : public test::GlTest {
  protected:
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        test::GlTest::TearDown();
    }

    /// A library whose lighting pass writes the factors, each times `scale`.
    gl::ShaderLibrary factorLibrary(const std::string& scale) {
        std::filesystem::create_directories(folder_ / "passes");
        std::ofstream(folder_ / "passes/lighting.frag") << "#define FACTOR_SCALE " << scale << "\n"
                                                        << kFactorShader;
        return gl::ShaderLibrary(folder_);
    }

    std::filesystem::path folder_ = "trap_sweep_test_" + std::to_string(::getpid());
};

TEST_P(TrapSweepTest, everyRadianceIsFiniteAndNotNegative) {
    const gl::ShaderLibrary library;
    for (const LightingModel& model : kModels) {
        LightingPass lighting(gl(), library, model);
        ShadingHarness harness(gl(), kSize, model.sheen);
        for (const Shape shape : kShapes) {
            TrapSweep sweep(2026, true, shape);
            long lit = 0;
            for (int frame = 0; frame < frameCount(); ++frame) {
                harness.setPoints(sweep.makePoints(harness.pointCount()));
                lighting.setLights(sweep.makeLights());
                for (const glm::vec4& radiance : harness.shade(lighting)) {
                    for (int c = 0; c < 3; ++c) {
                        ASSERT_TRUE(std::isfinite(radiance[c]) && radiance[c] >= 0.0f)
                            << nameOf(shape) << " " << radiance[c];
                    }
                    lit += radiance.x > 0.0f;
                }
            }
            EXPECT_GT(lit, 20'000) << "the sweep has to light something: " << nameOf(shape);
        }
    }
}

TEST_P(TrapSweepTest, everyFormFactorIsFinite) {
    const gl::ShaderLibrary library = factorLibrary("1.0");
    for (const LightingModel& model : kModels) {
        LightingPass lighting(gl(), library, model);
        ShadingHarness harness(gl(), kSize, model.sheen);
        for (const Shape shape : kShapes) {
            TrapSweep sweep(711, true, shape);
            for (int frame = 0; frame < frameCount(); ++frame) {
                harness.setPoints(sweep.makePoints(harness.pointCount()));
                lighting.setLights(sweep.makeLights());
                for (const glm::vec4& factors : harness.shade(lighting)) {
                    ASSERT_TRUE(std::isfinite(factors.x) && std::isfinite(factors.y))
                        << nameOf(shape);
                }
            }
        }
    }
}

TEST_P(TrapSweepTest, everyFormFactorIsInRange) {
    const gl::ShaderLibrary library = factorLibrary("1.0");
    for (const LightingModel& model : kModels) {
        LightingPass lighting(gl(), library, model);
        ShadingHarness harness(gl(), kSize, model.sheen);
        for (const Shape shape : kShapes) {
            TrapSweep sweep(713, false, shape);
            Range facing;
            Range averted;
            for (int frame = 0; frame < frameCount(); ++frame) {
                std::vector<ShadingPoint> points = sweep.makePoints(harness.pointCount());
                for (ShadingPoint& point : points) {
                    point.roughness = std::max(point.roughness, kRangeRoughness);
                }
                harness.setPoints(points);
                lighting.setLights(sweep.makeLights());
                const std::vector<glm::vec4> shaded = harness.shade(lighting);
                const std::vector<SurfacePixel> pixels = harness.decoded();
                for (std::size_t i = 0; i < shaded.size(); ++i) {
                    const float cosine = glm::dot(pixels[i].normalWorld, pixels[i].viewWorld);
                    (cosine > kAvertedCosine ? facing : averted).include(shaded[i]);
                }
            }
            const std::string name =
                nameOf(shape) + (" by model " + std::to_string(&model - kModels));
            RecordProperty(name, facing.describe());
            RecordProperty(name + ", averted", averted.describe());
            EXPECT_TRUE(facing.isWithin(kRangeTolerance)) << name << facing.describe();
            EXPECT_TRUE(averted.isWithin(kAvertedRangeTolerance)) << name << averted.describe();
            EXPECT_GT(facing.highest, 0.7f) << "some light has to fill a lobe: " << name;
        }
    }
}

TEST_P(TrapSweepTest, valueThatIsNotANumberIsSeen) {
    const gl::ShaderLibrary library = factorLibrary("uintBitsToFloat(0x7fc00000u)");
    LightingPass lighting(gl(), library);
    ShadingHarness harness(gl(), 64);
    for (const Shape shape : kShapes) {
        TrapSweep sweep(1, true, shape);
        harness.setPoints(sweep.makePoints(harness.pointCount()));
        lighting.setLights(sweep.makeLights());
        for (const glm::vec4& factors : harness.shade(lighting)) ASSERT_TRUE(std::isnan(factors.x));
    }
}

POLYLUME_ON_EVERY_BACKEND(TrapSweepTest);

}  // namespace
}  // namespace polylume
