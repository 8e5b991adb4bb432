// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lights/light_image_sampling.hpp"
#include "lights/light_outline.hpp"
#include "reference_scenes.hpp"
#include "support/test_lights.hpp"
#include "support/test_scenes.hpp"

// A Lambert floor under lights with pictures on them, against sums over the lights' planes.
namespace polylume::reference {
namespace {

constexpr glm::vec3 kAlbedo{0.8f, 0.5f, 0.3f};
constexpr glm::vec3 kNits{1000.0f, 700.0f, 400.0f};

/// A small part of a light.
struct Patch {
    glm::dvec3 position{0.0};
    glm::dvec3 radiance{0.0};  ///< Times area.
};

/// Adds the parts of corner + x edgeX + y edgeY, of `sign`.
void addPatches(std::vector<Patch>& patches, const PolygonLight& light, const glm::dvec3& corner,
                const glm::dvec3& edgeX, const glm::dvec3& edgeY, double sign = 1.0) {
    constexpr int kSteps = 96;
    const double area = glm::length(glm::cross(edgeX, edgeY)) / (kSteps * kSteps);
    for (int j = 0; j < kSteps; ++j) {
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec3 position =
                corner + (i + 0.5) / kSteps * edgeX + (j + 0.5) / kSteps * edgeY;
            const glm::dvec3 picture =
                sampleImage(*light.texture, textureCoordinates(*light.texture, position));
            patches.push_back({position, sign * area * picture * glm::dvec3(light.radiance)});
        }
    }
}

/// What the floor reflects of them.
glm::dvec3 reflected(const std::vector<Patch>& patches, const glm::dvec3& normal,
                     const glm::dvec3& position) {
    glm::dvec3 sum(0.0);
    for (const Patch& patch : patches) {
        const glm::dvec3 offset = patch.position - position;
        const double square = glm::dot(offset, offset);
        const double cosines = std::max(offset.y, 0.0) * std::abs(glm::dot(offset, normal));
        sum += cosines / (square * square) * patch.radiance;
    }
    return sum * glm::dvec3(kAlbedo) * std::numbers::inv_pi;
}

class TexturedFloorTest : public ::testing::Test {
  protected:
    const scene::Scene scene_ =
        testing::sceneOf(test::makeFloor(3.0f), testing::lambertMaterial(kAlbedo));
    const scene::Camera camera_ = test::makeCamera({0.5f, 3.0f, 4.0f}, {0, 0, 0}, 0.7f);
    ReferenceOptions options_ = testing::plainOptions({28, 20}, 4096);

    testing::Agreement compare(const std::vector<Patch>& patches) {
        const glm::dvec3 normal =
            glm::normalize(areaVector(options_.extraLights.polygons[0].contours[0]));
        return testing::compare(testing::trace(scene_, camera_, options_),
                                [&](const glm::dvec3& position, const glm::dvec3&) -> glm::dvec3 {
                                    return reflected(patches, normal, position);
                                });
    }
};

/// As testing::expectAgreement(), for pictures whose three channels are noisy each on its own:
/// 99.64 % of pixels are within in all three.
void expectColorAgreement(const testing::Agreement& agreement, const std::string& name) {
    EXPECT_GT(agreement.pixelCount, 400u) << name;
    EXPECT_GE(agreement.shareWithin4, 0.99) << name;
    EXPECT_LE(std::abs(agreement.relativeMeanError), 1e-3) << name;
}

/// Facing down and a little to the side.
PolygonLight makeRectangle() {
    PolygonLight light =
        testing::rectangleLight({0.3f, 1.2f, -0.2f}, {0.9f, 0.2f, 0.0f}, {0.0f, 0.0f, 0.6f}, kNits);
    const std::vector<glm::vec3>& c = light.contours[0];
    light.texture = testing::makePicture({5, 3}, c[3], c[2] - c[3], c[0] - c[3]);
    return light;
}

std::vector<Patch> patchesOf(const PolygonLight& rectangle) {
    std::vector<Patch> patches;
    const std::vector<glm::vec3>& c = rectangle.contours[0];
    addPatches(patches, rectangle, c[0], c[1] - c[0], c[3] - c[0]);
    return patches;
}

TEST_F(TexturedFloorTest, underARectangle) {
    const PolygonLight light = makeRectangle();
    options_.extraLights.polygons = {light};
    for (const LightSampling sampling : {LightSampling::solidAngle, LightSampling::area}) {
        options_.lightSampling = sampling;
        expectColorAgreement(compare(patchesOf(light)), "rectangle");
    }
    // The twin: a picture that is upside down.
    PolygonLight turned = light;
    turned.texture->origin += turned.texture->axisV;
    turned.texture->axisV = -turned.texture->axisV;
    EXPECT_LT(compare(patchesOf(turned)).shareWithin4, 0.5);
}

TEST_F(TexturedFloorTest, underATwoSidedRectangleFromBehind) {
    // Points of the light keep their colours: from behind the picture is mirrored.
    PolygonLight light = makeRectangle();
    const std::vector<Patch> patches = patchesOf(light);
    std::ranges::reverse(light.contours[0]);
    options_.extraLights.polygons = {light};
    EXPECT_EQ(compare(patches).shareWithin4, 0.0);
    options_.extraLights.polygons[0].twoSided = true;
    expectColorAgreement(compare(patches), "from behind");
}

TEST_F(TexturedFloorTest, underPicturesThatWrap) {
    PolygonLight light = makeRectangle();
    light.texture->origin += 0.3f * light.texture->axisU + 0.4f * light.texture->axisV;
    light.texture->axisU *= 0.4f;
    light.texture->axisV *= 0.45f;
    using enum TextureWrap;
    for (const auto& [u, v] : {std::pair(repeat, mirroredRepeat), {clampToEdge, repeat}}) {
        light.texture->wrapU = u;
        light.texture->wrapV = v;
        options_.extraLights.polygons = {light};
        expectColorAgreement(compare(patchesOf(light)), "wrapped");
    }
}

TEST_F(TexturedFloorTest, underAPolygonWithAHole) {
    PolygonLight light = test::makeHoledLight(1.0f);
    // Axes that are not at right angles.
    light.texture = testing::makePicture({4, 5}, {-1, 1, -1}, {2.5f, 0, 0.3f}, {-0.4f, 0, 3});
    options_.extraLights.polygons = {light};
    std::vector<Patch> patches;
    addPatches(patches, light, {-1, 1, -1}, {2.5, 0, 0}, {0, 0, 1.6});
    addPatches(patches, light, {-1, 1, 0.6}, {1.2, 0, 0}, {0, 0, 1.4});
    addPatches(patches, light, {-0.7, 1, -0.6}, {0.6, 0, 0}, {0, 0, 0.7}, -1.0);
    expectColorAgreement(compare(patches), "polygon");
}

TEST_F(TexturedFloorTest, anEvenPictureIsAFactor) {
    PolygonLight light = makeRectangle();
    light.texture->image = std::make_shared<LightImage>(
        LightImage{{2, 2}, std::vector<glm::vec3>(4, glm::vec3(0.25f, 0.5f, 2.0f))});
    options_.extraLights.polygons = {light};
    options_.pathCount = 64;
    const FloatImage image = testing::trace(scene_, camera_, options_);
    light.texture.reset();
    light.radiance *= glm::vec3(0.25f, 0.5f, 2.0f);
    options_.extraLights.polygons = {light};
    const FloatImage plain = testing::trace(scene_, camera_, options_);
    ASSERT_EQ(image.pixels.size(), plain.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        ASSERT_NEAR(image.pixels[i], plain.pixels[i], 1e-6f * std::abs(plain.pixels[i]));
    }
}

}  // namespace
}  // namespace polylume::reference
