// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "lighting/light_lists.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <random>

#include "bound_cases.hpp"
#include "core/text.hpp"
#include "gl/render/render_fixture.hpp"
#include "shader_twin.hpp"

namespace polylume {
namespace {

using test::BoundCases;
using test::ShadingHarness;
using test::ShadingPoint;
using Picture = std::vector<glm::vec4>;

constexpr int kSize = 64;

const LightingModel kModels[] = {
    {},
    {.quality = Quality::high},
    {.diffuse = Diffuse::burley},
    {.specular = Specular::beckmann, .diffuse = Diffuse::orenNayar, .quality = Quality::high},
    {.diffuse = Diffuse::burley, .quality = Quality::high, .sheen = true},
};

/// Seeded lights of all kinds all around the harness's points, many of them in facades.
class LightMaker {
  public:
    /// Without all kinds, shaders compile faster: rectangles, balls and disks.
    explicit LightMaker(unsigned seed, bool withAllKinds = true)
        : generator_(seed), withAllKinds_(withAllKinds) {
        auto image = std::make_shared<LightImage>();
        image->size = {4, 4};
        for (int i = 0; i < 16; ++i) {
            image->texels.emplace_back(uniform(0, 3), uniform(0, 1), uniform(0, 2));
        }
        image_ = image;
    }

    float uniform(float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(generator_);
    }
    int pick(int low, int high) {
        return std::uniform_int_distribution<int>(low, high)(generator_);
    }
    glm::vec3 vector() { return {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}; }
    /// The points lie about (0, 0, -5).
    glm::vec3 place() {
        const glm::vec3 offset = vector();
        return glm::vec3(0, 0, -5) + offset * (pick(0, 2) == 0 ? 2.0f : 40.0f);
    }

    LightSet lights(int count, bool withPunctuals = true) {
        LightSet set;
        for (int i = 0; i < count; ++i) addLight(withPunctuals, set);
        return set;
    }

  private:
    void addLight(bool withPunctuals, LightSet& set) {
        const glm::vec3 radiance = uniform(1, 50) * glm::vec3(1, 0.8f, 0.5f);
        const glm::vec3 center = place();
        const float size = 0.02f + 0.5f * uniform(0, 1) * uniform(0, 1);
        const bool twoSided = pick(0, 3) == 0;
        glm::vec3 x = glm::normalize(vector());
        glm::vec3 y = glm::normalize(glm::cross(x, vector()));
        const int kind = pick(0, 9);
        const bool isRare = kind == 1 || kind == 3 || (kind == 4 && !withPunctuals);
        switch (isRare && !withAllKinds_ ? 2 : kind) {
            case 0:
                set.spheres.push_back({center, size, radiance});
                return;
            case 1:
                set.tubes.push_back({center - x, center + x, 0.1f * size, radiance});
                return;
            case 2:
                set.ellipses.push_back({center, size * x, size * y, radiance, twoSided});
                return;
            case 3:
                set.ellipses.push_back({center, size * x, 0.3f * size * y, radiance, twoSided});
                return;
            case 4:
                if (!withPunctuals) break;
                set.punctuals.emplace_back();
                set.punctuals.back().position = center;
                set.punctuals.back().intensity = radiance;
                if (pick(0, 1) == 0) set.punctuals.back().range = uniform(1, 20);
                return;
            case 5:
            case 6:
            case 7:  // A window of a facade.
                x = {1, 0, 0}, y = {0, 1, 0};
                addPolygon({uniform(-8, 8), uniform(-8, 8), -30}, size * x, size * y, 4,
                           glm::vec3(20, 16, 10), false, set);
                return;
            default:
                break;
        }
        addPolygon(center, size * x, size * y, withAllKinds_ ? pick(3, 5) : 4, radiance, twoSided,
                   set);
        if (withAllKinds_ && pick(0, 5) == 0) {
            LightTexture texture;
            texture.image = image_;
            texture.origin = center;
            texture.axisU = size * x;
            texture.axisV = size * y;
            set.polygons.back().texture = texture;
        }
    }

    static void addPolygon(const glm::vec3& corner, const glm::vec3& x, const glm::vec3& y,
                           int sides, const glm::vec3& radiance, bool twoSided, LightSet& set) {
        PolygonLight light;
        light.contours = {{corner, corner + x, corner + x + y}};
        if (sides > 3) light.contours[0].push_back(corner + y);
        if (sides > 4) light.contours[0].push_back(corner + 0.3f * x + 0.5f * y);
        light.radiance = radiance;
        light.twoSided = twoSided;
        set.polygons.push_back(light);
    }

    std::mt19937 generator_;
    bool withAllKinds_;
    std::shared_ptr<const LightImage> image_;
};

/// The largest part of a pixel's change that `threshold` and rounding do not explain.
double largestExcess(const Picture& exact, const Picture& listed, double threshold) {
    double largest = -INFINITY;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double change =
                std::abs(static_cast<double>(exact[i][c]) - static_cast<double>(listed[i][c]));
            if (!std::isfinite(change)) return INFINITY;
            // Sums in another order.
            largest = std::max(largest, change - threshold - 1e-5 * std::abs(exact[i][c]) - 1e-7);
        }
    }
    return largest;
}

class LightListsTest : public test::RenderTest {
  protected:
    Picture shade(LightingPass& lighting, ShadingHarness& harness, std::optional<float> threshold) {
        lighting.setLightThreshold(threshold);
        return harness.shade(lighting);
    }

    /// The worst excess over five decades of thresholds and none, and how many lights were listed.
    double worstExcess(LightingPass& lighting, const LightSet& lights, unsigned seed,
                       std::string& message) {
        const bool sheen = lighting.model().sheen;
        ShadingHarness harness(gl(), kSize, sheen);
        harness.setPoints(BoundCases(seed).makePoints(kSize, sheen));
        lighting.setLights(lights);
        const Picture exact = shade(lighting, harness, std::nullopt);
        EXPECT_EQ(lighting.lightLists(), nullptr);
        double worst = -INFINITY;
        std::size_t last = 0, first = 0;
        for (const float threshold : {0.0f, 1e-4f, 1e-3f, 1e-2f, 1e-1f, 1.0f, 10.0f}) {
            const Picture listed = shade(lighting, harness, threshold);
            EXPECT_NE(lighting.lightLists(), nullptr);
            const double excess = largestExcess(exact, listed, threshold);
            const std::size_t count = lighting.lightLists()->listedLightCount();
            message += concat(" ", threshold, ": ", excess, " (", count, " lights)");
            worst = std::max(worst, excess);
            if (threshold == 0.0f) {
                first = count;
            } else {
                EXPECT_LE(count, last);
            }
            last = count;
        }
        EXPECT_LT(last, first);
        return worst;
    }
};

TEST_P(LightListsTest, noPixelChangesByMoreThanTheThreshold) {
    unsigned seed = GetParam() == Backend::egl ? 1 : 101;
    for (const LightingModel& model : kModels) {
        LightingPass lighting(gl(), library(), model);
        for (const int count : {40, 300}) {
            ++seed;
            const bool isFirst = model == kModels[0];
            const LightSet lights = LightMaker(seed, isFirst).lights(count, isFirst);
            std::string message;
            EXPECT_LE(worstExcess(lighting, lights, seed, message), 0.0)
                << "seed " << seed << ", " << count << " lights, diffuse "
                << static_cast<int>(model.diffuse) << (model.sheen ? ", sheen" : "")
                << (model.quality == Quality::high ? ", two lobes:" : ":") << message;
        }
    }
}

TEST_P(LightListsTest, brokenListsAreFound) {
    const gl::ShaderLibrary twin = test::makeTwin("culling/kernel_bound.glsl",
                                                  "kInversePi = 0.318309886", "kInversePi = 0.001");
    const LightSet lights = LightMaker(3, false).lights(300, false);
    std::string message;
    LightingPass lighting(gl(), twin, {});
    EXPECT_GT(worstExcess(lighting, lights, 3, message), 0.0) << message;
}

TEST_P(LightListsTest, fewLightsAreAllLitBy) {
    ShadingHarness harness(gl(), kSize);
    harness.setPoints(BoundCases(1).makePoints(kSize, false));
    LightingPass lighting(gl(), library(), {});
    lighting.setLights(
        LightMaker(1, false).lights(static_cast<int>(LightLists::kFewestLights) - 1));
    const Picture exact = shade(lighting, harness, std::nullopt);
    EXPECT_EQ(shade(lighting, harness, 100.0f), exact);
    EXPECT_EQ(lighting.lightLists(), nullptr);
}

TEST_P(LightListsTest, metalShowsEveryPunctualLight) {
    // Their highlights go by the BRDF, not by the tables, whose lobes end elsewhere.
    for (const Quality quality : {Quality::standard, Quality::high}) {
        std::vector<ShadingPoint> points = BoundCases(5).makePoints(kSize, false);
        for (ShadingPoint& point : points) {
            point.diffuseAlbedo = glm::vec3(0.0f);
            point.f0 = glm::vec3(1.0f);
            point.roughness = std::max(point.roughness, 0.3f);
        }
        ShadingHarness harness(gl(), kSize);
        harness.setPoints(points);
        LightMaker random(7);
        LightSet lights;
        for (int i = 0; i < 64; ++i) {
            lights.punctuals.emplace_back();
            lights.punctuals.back().position = random.place();
            lights.punctuals.back().intensity = glm::vec3(1000.0f);
        }
        LightingPass lighting(gl(), library(), {.quality = quality});
        lighting.setLights(lights);
        const Picture exact = shade(lighting, harness, std::nullopt);
        EXPECT_LE(largestExcess(exact, shade(lighting, harness, 0.0f), 0.0), 0.0);
    }
}

TEST_P(LightListsTest, hugeThresholdsHold) {
    ShadingHarness harness(gl(), kSize);
    std::vector<ShadingPoint> points = BoundCases(6).makePoints(kSize, false);
    // Hardly black.
    for (ShadingPoint& point : points) {
        point.diffuseAlbedo = glm::vec3(2e-5f);
        point.f0 = glm::vec3(2e-5f);
    }
    harness.setPoints(points);
    LightingPass lighting(gl(), library(), {});
    LightSet lights = LightMaker(2, false).lights(100, false);
    LightMaker random(3);
    for (int i = 0; i < 20; ++i) {
        lights.punctuals.emplace_back();
        lights.punctuals.back().position = random.place();
    }
    lighting.setLights(lights);
    const Picture exact = shade(lighting, harness, std::nullopt);
    for (const float threshold : {1e3f, 1e8f, 1e12f, 1e16f, 1e30f}) {
        EXPECT_LE(largestExcess(exact, shade(lighting, harness, threshold), threshold), 0.0)
            << threshold;
    }
}

TEST_P(LightListsTest, thousandsOfLightsTakeTurns) {
    LightingPass lighting(gl(), library(), {});
    const LightSet lights = LightMaker(7, false).lights(4000, false);
    ShadingHarness harness(gl(), kSize, false);
    harness.setPoints(BoundCases(7).makePoints(kSize, false));
    lighting.setLights(lights);
    const Picture exact = shade(lighting, harness, std::nullopt);
    for (const float threshold : {0.0f, 0.1f, 10.0f}) {
        const Picture listed = shade(lighting, harness, threshold);
        ASSERT_NE(lighting.lightLists(), nullptr);
        const std::size_t visits = shared::kMostRounds * lighting.lightLists()->tree().nodes.size();
        EXPECT_GT(visits, 4 * shared::kMostVisits);
        EXPECT_LE(largestExcess(exact, listed, threshold), 0.0) << threshold;
    }
}

TEST_P(LightListsTest, listsAreTheSameWithoutRoomForDecisions) {
    const gl::ShaderLibrary twin =
        test::makeTwin("passes/light_lists.comp",
                       "isKept = walk.decisionCount <= kDecisionsOfWord * lightList.tileCount.w",
                       "isKept = false");
    const LightSet lights = LightMaker(5, false).lights(600);
    ShadingHarness harness(gl(), kSize, false);
    harness.setPoints(BoundCases(5).makePoints(kSize, false));
    LightingPass lighting(gl(), library(), {}), without(gl(), twin, {});
    lighting.setLights(lights);
    without.setLights(lights);
    for (const float threshold : {0.0f, 0.01f, 1.0f}) {
        EXPECT_EQ(shade(without, harness, threshold), shade(lighting, harness, threshold));
        EXPECT_EQ(without.lightLists()->listedLightCount(),
                  lighting.lightLists()->listedLightCount());
    }
}

TEST_P(LightListsTest, longListsFindRoom) {
    // All lights before all points: no list is shorter than their number, but there is less room at
    // first.
    ShadingHarness harness(gl(), 48);
    harness.setPoints(std::vector<ShadingPoint>(48 * 48, {.distance = 6.0f}));
    LightMaker random(3);
    LightSet lights;
    for (int i = 0; i < 500; ++i) {
        lights.spheres.push_back({{random.uniform(-2, 2), random.uniform(-2, 2), -3}, 0.01f});
    }
    LightingPass lighting(gl(), library(), {});
    lighting.setLights(lights);
    const Picture exact = shade(lighting, harness, std::nullopt);
    for (int i = 0; i < 2; ++i) {
        EXPECT_LE(largestExcess(exact, shade(lighting, harness, 0.0f), 0.0), 0.0);
        EXPECT_EQ(lighting.lightLists()->listedLightCount(), 9u * 500u);
    }
    EXPECT_EQ(lighting.lightLists()->tileCount(), glm::ivec2(3));
}

TEST_P(LightListsTest, picturesOfAnySizeAndWithoutSurfaces) {
    const LightSet lights = LightMaker(9, false).lights(100);
    LightingPass lighting(gl(), library(), {});
    lighting.setLights(lights);
    for (const int size : {1, 15, 16, 17, 50}) {
        for (const float distance : {5.0f, 16.0f}) {  // The latter: background.
            ShadingHarness harness(gl(), size);
            std::vector<ShadingPoint> points(static_cast<std::size_t>(size * size),
                                             {.distance = distance});
            // Two pixels of the last row alone.
            if (distance > 10.0f && size > 1) points.back().distance = points[1].distance = 4.0f;
            harness.setPoints(points);
            const Picture exact = shade(lighting, harness, std::nullopt);
            for (const float threshold : {0.0f, 0.1f}) {
                EXPECT_LE(largestExcess(exact, shade(lighting, harness, threshold), threshold), 0.0)
                    << size << " " << distance << " " << threshold;
            }
        }
    }
}

TEST_P(LightListsTest, lightsThatTouchSurfaces) {
    // In the plane of the points, through them, about them and just before them.
    constexpr float kFar = 4.0f;
    ShadingHarness harness(gl(), kSize);
    std::vector<ShadingPoint> points(kSize * kSize, {.distance = kFar});
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].roughness = static_cast<float>(i % kSize) / kSize;
        if (i % 5 == 0) points[i].normalWorld = glm::normalize(glm::vec3(1, 0, 0.3f));
    }
    harness.setPoints(points);
    LightSet lights;
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 center(0.03f * static_cast<float>(i) - 0.9f, 0.1f, -kFar);
        const glm::vec3 x(0.1f, 0, 0), y(0, 0.1f, 0), z(0, 0, 0.1f);
        switch (i % 6) {
            case 0:
                lights.ellipses.push_back({center, x, y, glm::vec3(10.0f), true});
                break;
            case 1:
                lights.ellipses.push_back({center, x, z, glm::vec3(10.0f), true});
                break;
            case 2:
                lights.spheres.push_back({center, 0.1f, glm::vec3(10.0f)});
                break;
            case 3:
                lights.tubes.push_back({center, center + y, 0.02f, glm::vec3(10.0f)});
                break;
            case 4:
                lights.punctuals.emplace_back();
                lights.punctuals.back().position = center + 0.01f * z;
                break;
            default: {
                PolygonLight light;
                const glm::vec3 corner = center + 1e-4f * z;
                light.contours = {{corner, corner + y, corner + x + y, corner + x}};
                light.radiance = glm::vec3(10.0f);
                lights.polygons.push_back(light);
                break;
            }
        }
    }
    LightingPass lighting(gl(), library(), {});
    lighting.setLights(lights);
    const Picture exact = shade(lighting, harness, std::nullopt);
    for (const float threshold : {0.0f, 1e-3f, 0.1f, 10.0f}) {
        EXPECT_LE(largestExcess(exact, shade(lighting, harness, threshold), threshold), 0.0)
            << threshold;
    }
}

TEST_P(LightListsTest, listsFollowLightsThatChange) {
    ShadingHarness harness(gl(), kSize);
    harness.setPoints(BoundCases(8).makePoints(kSize, false));
    LightMaker random(4);
    LightSet lights = random.lights(80);
    LightingPass lighting(gl(), library(), {});
    lighting.setLights(lights);
    Picture last = shade(lighting, harness, 0.01f);
    for (int i = 0; i < 3; ++i) {
        for (glm::vec3& vertex : lights.polygons[2].contours[0]) vertex += glm::vec3(0, 0.5f, 1);
        lights.polygons[2].radiance = glm::vec3(1e4f);
        lighting.updatePolygons(2, std::span(&lights.polygons[2], 1));
        lights.spheres[0].center = {0.1f, 0.1f * static_cast<float>(i), -2};
        lights.spheres[0].radiance = glm::vec3(2e3f);
        lighting.updateSpheres(0, std::span(&lights.spheres[0], 1));
        const Picture exact = shade(lighting, harness, std::nullopt);
        const Picture listed = shade(lighting, harness, 0.01f);
        EXPECT_LE(largestExcess(exact, listed, 0.01), 0.0) << i;
        EXPECT_NE(listed, last);
        last = listed;
    }
    // Images, of which the GPU alone knows how bright they are.
    const auto textured = std::ranges::find_if(
        lights.polygons, [](const PolygonLight& light) { return light.texture.has_value(); });
    ASSERT_NE(textured, lights.polygons.end());
    gl::Texture bright(gl(), GL_RGBA32F, {4, 4}, 1, "bright");
    const std::vector<glm::vec4> texels(16, glm::vec4(1e4f));
    bright.upload(GL_RGBA, GL_FLOAT, texels.data());
    lighting.updateLightTexture(static_cast<std::size_t>(textured - lights.polygons.begin()),
                                bright.name());
    const Picture exact = shade(lighting, harness, std::nullopt);
    EXPECT_LE(largestExcess(exact, shade(lighting, harness, 0.01f), 0.01), 0.0);
}

/// A ball, a bumpy wall, a smooth floor: for the camera's own G-buffer.
scene::Scene makeRoom() {
    scene::Scene scene = test::makeScene(test::makeFloor(6.0f), 0.15f, 0.0f, glm::vec3(0.6f));
    scene::Material metal;
    metal.roughnessFactor = 0.3f;
    test::addMesh(scene, test::makeSphere(16), metal,
                  glm::translate(glm::mat4(1.0f), {0.0f, 1.0f, 0.0f}));
    scene::Material wall;
    wall.roughnessFactor = 0.7f;
    wall.metallicFactor = 0.0f;
    scene::Mesh waves = test::makeQuad(3.0f, -3.0f);
    for (std::size_t i = 0; i < waves.normals.size(); ++i) {
        waves.normals[i] = glm::normalize(glm::vec3(i % 2 == 0 ? 0.5f : -0.5f, 0.2f, 1.0f));
    }
    test::addMesh(scene, waves, wall);
    return scene;
}

/// Frame after frame, |change| <= |change of the exact frames| + 2 thresholds.
TEST_P(LightListsTest, nothingFlickers) {
    constexpr glm::ivec2 kFrame(40, 30);
    constexpr float kThreshold = 0.05f;
    constexpr int kSteps = 200;
    const scene::Scene room = makeRoom();
    LightMaker random(21);
    LightSet lights;
    for (int i = 0; i < 90; ++i) {
        const glm::vec3 corner(random.uniform(-6, 6), random.uniform(0.5f, 6), -8);
        PolygonLight light;
        light.contours = {{corner, corner + glm::vec3(0.4f, 0, 0),
                           corner + glm::vec3(0.4f, 0.3f, 0), corner + glm::vec3(0, 0.3f, 0)}};
        light.radiance = glm::vec3(30, 25, 15);
        light.twoSided = i % 2 == 0;
        lights.polygons.push_back(light);
        if (i % 3 > 0) continue;
        lights.spheres.push_back({6.0f * random.vector() + glm::vec3(0, 7, 0), 0.1f});
    }
    for (const bool movesCamera : {false, true}) {
        FrameRenderer renderer(gl(), library(), room, test::makeCamera({1, 2, 6}, {0, 1, 0}),
                               test::makeOptions(kFrame));
        renderer.setLights(lights);
        const auto frame = [&](std::optional<float> threshold) {
            renderer.setLightThreshold(threshold);
            renderer.clearSum();
            renderer.drawFrame({0.5, 0.5});
            renderer.accumulate();
            return renderer.readMean(1).pixels;
        };
        std::vector<float> lastExact, lastListed;
        double worst = -INFINITY;
        for (int step = 0; step < kSteps; ++step) {
            const float at = 0.002f * static_cast<float>(step);
            if (movesCamera) {
                renderer.setCamera(test::makeCamera({1 + at, 2 - 0.3f * at, 6 - at}, {0, 1, 0}));
            } else {
                LightSet moved = lights;
                moved.spheres[0].center = {at - 0.2f, 2.4f, 0.8f};
                for (glm::vec3& vertex : moved.polygons[0].contours[0]) vertex.z += at;
                renderer.setLights(moved);
            }
            const std::vector<float> exact = frame(std::nullopt);
            const std::vector<float> listed = frame(kThreshold);
            for (std::size_t i = 0; i < exact.size(); ++i) {
                ASSERT_LE(std::abs(exact[i] - listed[i]), kThreshold + 1e-5f * exact[i] + 1e-7f)
                    << step << " " << i;
                if (step == 0) continue;
                const double change = std::abs(exact[i] - lastExact[i]);
                worst = std::max(worst, std::abs(listed[i] - lastListed[i]) - change -
                                            2.0 * kThreshold - 2e-5 * exact[i]);
            }
            lastExact = exact;
            lastListed = listed;
        }
        EXPECT_LE(worst, 0.0) << (movesCamera ? "camera" : "lights");
        EXPECT_NE(lastExact, lastListed);
    }
}

POLYLUME_ON_EVERY_BACKEND(LightListsTest);

}  // namespace
}  // namespace polylume
