// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>

#include "gl/lighting/shading_harness.hpp"
#include "lights/light_outline.hpp"
#include "render_fixture.hpp"
#include "support/test_lights.hpp"
#include "view/scene_lights.hpp"

namespace polylume {
namespace {

using test::Frame;

constexpr glm::ivec2 kSize{96, 72};

/// The scene's area lights as the polygons that the lighting pass makes of them.
LightSet polygonsOf(const scene::Scene& scene) {
    LightSet lights = lightsOf(scene, {});
    for (const EllipseLight& light : lights.ellipses) {
        lights.polygons.push_back({{outline(light)}, light.radiance, light.twoSided});
    }
    return lights;
}

class AreaLightTest : public test::RenderTest {
  protected:
    /// Compares every lit pixel with the closed form in double from the decoded G-buffer, with
    /// `claimed` taken for the light that was drawn with.
    static void compareWithFormFactors(const Frame& frame, const PolygonLight& claimed,
                                       std::size_t& wrongCount, double& worst) {
        std::size_t surfaceCount = 0;
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            const SurfacePixel& pixel = frame.gbuffer[i];
            if (!pixel.isSurface) continue;
            ++surfaceCount;
            const double factor = test::shadeInDouble(pixel, claimed, table()).diffuse;
            for (int c = 0; c < 3; ++c) {
                const double nits = claimed.radiance[c];
                const double expected = pixel.diffuseAlbedo[c] * factor * nits;
                const double error = std::abs(frame.radiance[i][c] - expected);
                const double tolerance = std::max(1e-4 * expected, 1e-6 * nits);
                worst = std::max(worst, error / tolerance);
                // A NaN is wrong, too.
                if (!(error <= tolerance)) ++wrongCount;
            }
        }
        EXPECT_GT(surfaceCount, 4000u);
    }

    void expectFormFactors(const Frame& frame, const PolygonLight& light) {
        std::size_t wrongCount = 0;
        double worst = 0.0;
        compareWithFormFactors(frame, light, wrongCount, worst);
        EXPECT_EQ(wrongCount, 0u);
        RecordProperty("largest error in tolerances", std::to_string(worst));

        // The twin: a light moved by a thousandth of its height is found nearly everywhere.
        PolygonLight moved = light;
        for (auto& contour : moved.contours) {
            for (glm::vec3& vertex : contour) vertex.y *= 1.001f;
        }
        compareWithFormFactors(frame, moved, wrongCount, worst);
        EXPECT_GT(wrongCount, frame.gbuffer.size());
    }
};

const scene::Camera& floorCamera() {
    static const scene::Camera camera = test::makeCamera({0.5f, 2.5f, 6.0f}, {0, 0, 0});
    return camera;
}

TEST_P(AreaLightTest, lambertFloorUnderARectangleIsItsFormFactor) {
    scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), {0.8f, 0.5f, 0.2f});
    scene.areaLights.push_back(test::makeRectangleLight({0.2f, 1.5f, -0.5f}, {0.1f, -1, 0.2f},
                                                        {2.0f, 1.2f}, {1000.0f, 700.0f, 20.0f}));
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    expectFormFactors(drawFrame(scene, floorCamera(), options), polygonsOf(scene).polygons.front());
}

TEST_P(AreaLightTest, lambertFloorUnderAConcavePolygonWithAHoleIsItsFormFactor) {
    const scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), {0.8f, 0.5f, 0.2f});
    const LightSet lights{{test::makeHoledLight(1.3f)}, {}};
    expectFormFactors(drawFrame(scene, floorCamera(), test::makeOptions(kSize), &lights),
                      lights.polygons.front());
}

TEST_P(AreaLightTest, theHoleTakesItsShareAway) {
    const scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), glm::vec3(0.6f));
    LightSet lights{{test::makeHoledLight(1.3f)}, {}};
    const RenderOptions options = test::makeOptions(kSize);
    const Frame holed = drawFrame(scene, floorCamera(), options, &lights);
    PolygonLight hole = lights.polygons.front();
    hole.contours = {{hole.contours[1].rbegin(), hole.contours[1].rend()}};
    lights.polygons.front().contours.pop_back();
    const Frame full = drawFrame(scene, floorCamera(), options, &lights);
    lights.polygons = {hole};
    const Frame alone = drawFrame(scene, floorCamera(), options, &lights);
    float largest = 0.0f;
    for (std::size_t i = 0; i < full.radiance.size(); ++i) {
        // Sums of float, of a light of 1000 nits.
        ASSERT_NEAR(holed.radiance[i].x + alone.radiance[i].x, full.radiance[i].x, 2e-3f);
        largest = std::max(largest, alone.radiance[i].x);
    }
    EXPECT_GT(largest, 5.0f);
}

TEST_P(AreaLightTest, aSunkenLightDoesNotReachBelowTheFloor) {
    // Half of it is under the floor: only the upper half counts.
    scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), glm::vec3(0.8f));
    scene.areaLights.push_back(
        test::makeRectangleLight({0, 0, -1}, {0, 0, 1}, {2.0f, 2.0f}, glm::vec3(1000.0f)));
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    const Frame sunken = drawFrame(scene, floorCamera(), options);
    scene.areaLights.front() =
        test::makeRectangleLight({0, 0.5f, -1}, {0, 0, 1}, {2.0f, 1.0f}, glm::vec3(1000.0f));
    const Frame upper = drawFrame(scene, floorCamera(), options);
    float largest = 0.0f;
    for (std::size_t i = 0; i < upper.radiance.size(); ++i) {
        ASSERT_NEAR(sunken.radiance[i].x, upper.radiance[i].x, 2e-3f);
        largest = std::max(largest, upper.radiance[i].x);
    }
    EXPECT_GT(largest, 100.0f);
}

class SpecularTest : public AreaLightTest {
  protected:
    static scene::Scene makeSpecularScene(float roughness) {
        // A metal and a dielectric: F0 from 0.3 to 0.9, and 0.08.
        scene::Scene scene =
            test::makeScene(test::makeFloor(4.0f), roughness, 1.0f, {0.9f, 0.6f, 0.3f});
        scene::Material plastic;
        plastic.metallicFactor = 0.0f;
        plastic.roughnessFactor = roughness;
        plastic.ior = 1.8f;
        test::addMesh(scene, test::makeSphere(), plastic,
                      glm::translate(glm::mat4(1.0f), {0.3f, 1.0f, 0.5f}));
        scene.areaLights.push_back(test::makeRectangleLight({-1.5f, 2.2f, -1.5f}, {0.5f, -1, 1},
                                                            {1.6f, 1.0f}, {1000, 800, 600}));
        return scene;
    }

    /// By design.md section 4: luminance * reflectance * E / H.
    static glm::dvec3 specularOf(const SurfacePixel& pixel, const LightSet& lights) {
        glm::dvec3 sum(0.0);
        for (const PolygonLight& light : lights.polygons) {
            sum += test::shadeInDouble(pixel, light, table()).specular * glm::dvec3(light.radiance);
        }
        return sum * reflectanceOf(pixel);
    }

    static glm::dvec3 reflectanceOf(const SurfacePixel& pixel) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(pixel.normalWorld));
        const glm::dvec3 view = glm::normalize(glm::dvec3(pixel.viewWorld));
        const double cosView = std::clamp(glm::dot(normal, view), 1e-4, 1.0);
        const ltc::TableEntry entry = table().lookup(pixel.roughness, cosView);
        return glm::dvec3(pixel.f0) * (entry.albedo - entry.fresnel) +
               static_cast<double>(pixel.f90) * entry.fresnel;
    }

    /// The largest difference over the image as a fraction of its largest value.
    double largestError(const Frame& frame, const LightSet& lights) {
        double largest = 0.0;
        double error = 0.0;
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            if (!frame.gbuffer[i].isSurface) continue;
            const glm::dvec3 expected = specularOf(frame.gbuffer[i], lights);
            for (int c = 0; c < 3; ++c) {
                largest = std::max(largest, expected[c]);
                const double difference = std::abs(frame.radiance[i][c] - expected[c]);
                error = std::isfinite(difference) ? std::max(error, difference) : INFINITY;
            }
        }
        EXPECT_GT(largest, 10.0);
        return error / largest;
    }
};

TEST_P(SpecularTest, equalsDoublePrecisionOnAFloorAndASphere) {
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    options.lobes = Lobes::specular;
    for (const float roughness : {0.05f, 0.1f, 0.35f, 0.5f, 0.75f, 1.0f}) {
        const scene::Scene scene = makeSpecularScene(roughness);
        const Frame frame = drawFrame(scene, floorCamera(), options);
        const double error = largestError(frame, polygonsOf(scene));
        RecordProperty("r = " + std::to_string(roughness), std::to_string(error));
        EXPECT_LT(error, 1e-4) << "r = " << roughness;
    }
}

TEST_P(SpecularTest, theComparisonFindsARoughnessOffByAHundredth) {
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    options.lobes = Lobes::specular;
    const scene::Scene scene = makeSpecularScene(0.35f);
    Frame frame = drawFrame(scene, floorCamera(), options);
    for (SurfacePixel& pixel : frame.gbuffer) pixel.roughness += 0.01f;
    EXPECT_GT(largestError(frame, polygonsOf(scene)), 1e-3);
}

TEST_P(SpecularTest, whatIsReflectedAtTheSurfaceIsNotScattered) {
    // Diffuse = albedo (1 - R) E L with R the largest component of the specular reflectance.
    scene::Scene scene = makeSpecularScene(0.35f);
    scene.materials.front().metallicFactor = 0.0f;
    scene.materials.front().specularColorFactor = {1.0f, 5.0f, 20.0f};
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    options.lobes = Lobes::diffuse;
    const Frame frame = drawFrame(scene, floorCamera(), options);
    const PolygonLight light = polygonsOf(scene).polygons.front();
    double largest = 0.0;
    for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
        const SurfacePixel& pixel = frame.gbuffer[i];
        if (!pixel.isSurface) continue;
        const glm::dvec3 reflectance = reflectanceOf(pixel);
        const double rest = 1.0 - std::max({reflectance.r, reflectance.g, reflectance.b});
        const double factor = test::shadeInDouble(pixel, light, table()).diffuse;
        for (int c = 0; c < 3; ++c) {
            const double expected = rest * factor * pixel.diffuseAlbedo[c] * light.radiance[c];
            // The larger of 1e-4 relative and 1e-6 of the light, as for Lambert alone.
            ASSERT_NEAR(frame.radiance[i][c], expected, std::max(1e-4 * expected, 1e-3));
            largest = std::max(largest, expected);
        }
    }
    EXPECT_GT(largest, 10.0);
}

TEST_P(SpecularTest, lobesAndEmissionAddUp) {
    scene::Scene scene = makeSpecularScene(0.35f);
    scene.materials.back().emissiveFactor = {30.0f, 20.0f, 10.0f};
    RenderOptions options = test::makeOptions(kSize);
    const Frame all = drawFrame(scene, floorCamera(), options);
    options.lobes = Lobes::diffuse;
    const Frame diffuse = drawFrame(scene, floorCamera(), options);
    options.lobes = Lobes::specular;
    const Frame specular = drawFrame(scene, floorCamera(), options);
    bool emits = false;
    for (std::size_t i = 0; i < all.radiance.size(); ++i) {
        const glm::vec3 emission = all.gbuffer[i].emission;
        emits = emits || emission.x == 30.0f;
        for (int c = 0; c < 3; ++c) {
            // Three roundings of values of up to 1000.
            ASSERT_NEAR(all.radiance[i][c] - emission[c],
                        diffuse.radiance[i][c] + specular.radiance[i][c], 2e-4f);
        }
    }
    EXPECT_TRUE(emits);
}

TEST_P(AreaLightTest, twoSidedLightsShineBackwards) {
    scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), glm::vec3(0.8f));
    scene.areaLights.push_back(
        test::makeRectangleLight({0, 1.5f, 0}, {0, 1, 0}, {2.0f, 1.2f}, glm::vec3(1000.0f)));
    RenderOptions options = test::makeOptions(kSize);
    options.hideLights = true;
    const Frame away = drawFrame(scene, floorCamera(), options);
    options.twoSided = true;
    const Frame both = drawFrame(scene, floorCamera(), options);
    options.twoSided = false;
    scene.areaLights.front() =
        test::makeRectangleLight({0, 1.5f, 0}, {0, -1, 0}, {2.0f, 1.2f}, glm::vec3(1000.0f));
    const Frame toward = drawFrame(scene, floorCamera(), options);
    float largest = 0.0f;
    for (std::size_t i = 0; i < away.radiance.size(); ++i) {
        ASSERT_EQ(away.radiance[i].x, 0.0f);
        ASSERT_NEAR(both.radiance[i].x, toward.radiance[i].x, 1e-3f);
        largest = std::max(largest, both.radiance[i].x);
    }
    EXPECT_GT(largest, 100.0f);
}

POLYLUME_ON_EVERY_BACKEND(AreaLightTest);
POLYLUME_ON_EVERY_BACKEND(SpecularTest);

}  // namespace
}  // namespace polylume
