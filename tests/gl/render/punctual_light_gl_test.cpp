// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <functional>
#include <glm/gtc/constants.hpp>

#include "brdf/ggx.hpp"
#include "render_fixture.hpp"

namespace polylume {
namespace {

using test::Frame;

constexpr glm::ivec2 kSize{96, 72};
constexpr double kPi = glm::pi<double>();

/// Illuminance on the floor in lux, at a point given in double.
using Illuminance = std::function<double(const glm::dvec3& point)>;

class PunctualLightTest : public test::RenderTest {
  protected:
    /// A Lambert floor shows albedo / pi times the illuminance, within 1e-5 of the picture's
    /// largest value: float's rounding in a dozen operations.
    void expectIlluminance(const scene::PunctualLight& light, const Illuminance& illuminance) {
        scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), {0.8f, 0.4f, 0.2f});
        scene.punctualLights.push_back(light);
        const Frame frame = drawFrame(scene, test::makeCamera({0.5f, 2.5f, 6.0f}, {0, 0, 0}),
                                      test::makeOptions(kSize));
        double largest = 0.0;
        double error = 0.0;
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            const SurfacePixel& pixel = frame.gbuffer[i];
            if (!pixel.isSurface) continue;
            for (int c = 0; c < 3; ++c) {
                const double expected = pixel.diffuseAlbedo[c] / kPi * light.intensity[c] *
                                        illuminance(glm::dvec3(pixel.positionWorld));
                largest = std::max(largest, expected);
                const double difference = std::abs(frame.radiance[i][c] - expected);
                error = std::isfinite(difference) ? std::max(error, difference) : INFINITY;
            }
        }
        EXPECT_GT(largest, 1.0);
        EXPECT_LT(error / largest, 1e-5);
    }
};

const glm::vec3 kPosition(0.3f, 1.5f, -0.4f);

/// cos / d^2 of a floor of normal +y.
double pointFactor(const glm::dvec3& point) {
    const glm::dvec3 offset = glm::dvec3(kPosition) - point;
    const double distance = glm::length(offset);
    return offset.y / (distance * distance * distance);
}

TEST_P(PunctualLightTest, pointLightFallsWithTheSquare) {
    scene::PunctualLight light;
    light.position = kPosition;
    light.intensity = {900, 600, 300};
    expectIlluminance(light, pointFactor);
}

TEST_P(PunctualLightTest, rangeEndsTheLight) {
    scene::PunctualLight light;
    light.position = kPosition;
    light.intensity = {900, 600, 300};
    light.range = 2.5f;
    // KHR_lights_punctual, "Range Property": max(min(1 - (d / range)^4, 1), 0) / d^2.
    expectIlluminance(light, [](const glm::dvec3& point) {
        const double ratio = glm::distance(glm::dvec3(kPosition), point) / 2.5;
        return pointFactor(point) * std::clamp(1.0 - std::pow(ratio, 4.0), 0.0, 1.0);
    });
}

TEST_P(PunctualLightTest, directionalLightIsTheSameEverywhere) {
    scene::PunctualLight light;
    light.type = scene::PunctualLightType::directional;
    light.direction = glm::normalize(glm::vec3(0.6f, -0.8f, 0.1f));
    light.intensity = {90, 60, 30};
    light.position = {100, -100, 100};  // Has no meaning for it.
    const double cosine = -light.direction.y;
    expectIlluminance(light, [cosine](const glm::dvec3&) { return cosine; });
}

TEST_P(PunctualLightTest, spotFadesBetweenItsCones) {
    scene::PunctualLight light;
    light.type = scene::PunctualLightType::spot;
    light.position = kPosition;
    light.direction = glm::normalize(glm::vec3(-0.2f, -1.0f, 0.3f));
    light.intensity = {900, 600, 300};
    light.innerConeAngle = 0.3f;
    light.outerConeAngle = 0.7f;
    // KHR_lights_punctual, "Inner and Outer Cone Angles".
    expectIlluminance(light, [&](const glm::dvec3& point) {
        const double cosine =
            glm::dot(glm::normalize(point - glm::dvec3(kPosition)), glm::dvec3(light.direction));
        const double outer = std::cos(0.7);
        const double fade = std::clamp((cosine - outer) / (std::cos(0.3) - outer), 0.0, 1.0);
        return pointFactor(point) * fade * fade;
    });
}

TEST_P(PunctualLightTest, sharpSpotHasAnEdge) {
    scene::Scene scene = test::makeLambertScene(test::makeFloor(4.0f), glm::vec3(0.8f));
    scene::PunctualLight light;
    light.type = scene::PunctualLightType::spot;
    light.position = kPosition;
    light.direction = {0, -1, 0};
    light.intensity = glm::vec3(100.0f);
    light.innerConeAngle = light.outerConeAngle = 0.5f;
    scene.punctualLights.push_back(light);
    const Frame frame =
        drawFrame(scene, test::makeCamera({0.5f, 2.5f, 6.0f}, {0, 0, 0}), test::makeOptions(kSize));
    int insideCount = 0;
    int outsideCount = 0;
    for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
        if (!frame.gbuffer[i].isSurface) continue;
        const glm::vec3 offset = frame.gbuffer[i].positionWorld - kPosition;
        const float angle = std::acos(-offset.y / glm::length(offset));
        const double full = 0.8 / kPi * 100.0 * pointFactor(frame.gbuffer[i].positionWorld);
        // A width of 0.001 in the cosine is 0.002 rad at 0.5 rad.
        if (angle > 0.5f + 1e-4f) {
            ++outsideCount;
            ASSERT_EQ(frame.radiance[i].x, 0.0f);
        } else if (angle < 0.5f - 3e-3f) {
            ++insideCount;
            ASSERT_NEAR(frame.radiance[i].x, full, 1e-4 * full);
        }
    }
    EXPECT_GT(insideCount, 50);
    EXPECT_GT(outsideCount, 1000);
}

TEST_P(PunctualLightTest, specularIsGgx) {
    // F0 = F90 = 1: the BRDF itself, with the view and light of the decoded G-buffer.
    for (const float roughness : {0.2f, 0.5f, 1.0f}) {
        scene::Scene scene =
            test::makeScene(test::makeFloor(4.0f), roughness, 1.0f, glm::vec3(1.0f));
        scene::PunctualLight light;
        light.position = kPosition;
        light.intensity = glm::vec3(100.0f);
        scene.punctualLights.push_back(light);
        const Frame frame = drawFrame(scene, test::makeCamera({0.5f, 2.5f, 6.0f}, {0, 0, 0}),
                                      test::makeOptions(kSize));
        const brdf::Ggx ggx;
        double largest = 0.0;
        double error = 0.0;
        for (std::size_t i = 0; i < frame.gbuffer.size(); ++i) {
            const SurfacePixel& pixel = frame.gbuffer[i];
            if (!pixel.isSurface) continue;
            // The floor's normal is +y: swapping y and z makes it the shading frame's.
            const glm::dvec3 offset = glm::dvec3(kPosition) - glm::dvec3(pixel.positionWorld);
            const glm::dvec3 toLight = glm::normalize(offset);
            const glm::dvec3 view = glm::normalize(glm::dvec3(pixel.viewWorld));
            const double expected =
                100.0 / glm::dot(offset, offset) *
                ggx.evaluate({view.x, view.z, view.y}, {toLight.x, toLight.z, toLight.y},
                             pixel.roughness);
            largest = std::max(largest, expected);
            error = std::max(error, std::abs(frame.radiance[i].x - expected));
        }
        EXPECT_GT(largest, 1.0);
        // The peak's slope times the float positions' rounding.
        EXPECT_LT(error / largest, 5e-5) << roughness;
    }
}

POLYLUME_ON_EVERY_BACKEND(PunctualLightTest);

}  // namespace
}  // namespace polylume
