// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "lights/light_image_sampling.hpp"
#include "reference_scenes.hpp"
#include "support/test_scenes.hpp"

// Lights that the camera sees, each pixel against geometry.
namespace polylume::reference {
namespace {

constexpr glm::vec3 kNits{500.0f, 600.0f, 700.0f};
constexpr glm::vec3 kBackground{3.0f, 2.0f, 1.0f};

/// What is at a place of the picture.
struct Seen {
    double height = 0.0;  ///< Towards the camera.
    glm::dvec3 normal{0.0};
    glm::dvec3 radiance{kNits};
};

using Shape = std::function<std::optional<Seen>(const glm::dvec2& place)>;

/// The camera is 5 above the plane of x and z and looks down; +x is to the right, -z up.
class SeenLightTest : public ::testing::Test {
  protected:
    SeenLightTest() {
        options_.hideLights = false;
        options_.background = kBackground;
        std::get<scene::Orthographic>(camera_.projection).zFar = 20.0f;
    }

    void expect(const Shape& shape) {
        const FloatImage image = testing::trace(scene_, camera_, options_);
        const std::size_t depth = image.channelIndex("depth.Z").value();
        int hits = 0, misses = 0;
        for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
            const auto x = static_cast<double>(i % 64), y = static_cast<double>(i / 64);
            const glm::dvec2 place = 2.0 * ((glm::dvec2(x, y) + 0.5) / 32.0 - 1.0);
            const std::optional<Seen> seen = shape(place);
            const glm::dvec3 color = testing::color(image, i);
            if (!seen) {
                ++misses;
                EXPECT_EQ(color, glm::dvec3(kBackground)) << place.x << ", " << place.y;
                continue;
            }
            ++hits;
            EXPECT_LE(glm::length(color - seen->radiance), 1e-4 * glm::length(seen->radiance));
            // At the outline of a ball a rounding of the place shows by its root.
            EXPECT_NEAR(image.pixels[i * image.channelCount() + depth], 5.0 - seen->height, 1e-4);
            EXPECT_LT(glm::length(testing::layer(image, "normal", i) - seen->normal), 1e-3);
            const glm::dvec3 position(place.x, seen->height, place.y);
            EXPECT_LT(glm::length(testing::layer(image, "position", i) - position), 1e-4);
        }
        EXPECT_GT(hits, 100);
        EXPECT_GT(misses, 100);
    }

    scene::Scene scene_;
    scene::Camera camera_ = testing::topCamera(2.0f);
    ReferenceOptions options_ = testing::plainOptions({64, 64}, 16);
};

std::optional<Seen> ballAt(const glm::dvec3& center, double radius, const glm::dvec2& place) {
    const glm::dvec2 aside = place - glm::dvec2(center.x, center.z);
    const double square = radius * radius - glm::dot(aside, aside);
    if (square < 0.0) return std::nullopt;
    const glm::dvec3 normal = glm::dvec3(aside.x, std::sqrt(square), aside.y) / radius;
    return Seen{center.y + std::sqrt(square), normal};
}

TEST_F(SeenLightTest, aSphere) {
    options_.extraLights.spheres = {{{0.2f, 0.3f, -0.1f}, 0.83f, kNits}};
    expect([](const glm::dvec2& place) {
        return ballAt(glm::dvec3(0.2f, 0.3f, -0.1f), 0.83f, place);
    });
}

TEST_F(SeenLightTest, aTube) {
    options_.extraLights.tubes = {{{-0.7f, 0.3f, 0.2f}, {0.9f, 0.3f, 0.2f}, 0.43f, kNits}};
    expect([](const glm::dvec2& place) -> std::optional<Seen> {
        const double nearest = std::clamp<double>(place.x, -0.7f, 0.9f);
        return ballAt({nearest, 0.3f, 0.2f}, 0.43f, place);
    });
}

TEST_F(SeenLightTest, theInsideOfAnInwardSphere) {
    // Cut open by the near plane at a height of 0.5.
    auto& lens = std::get<scene::Orthographic>(camera_.projection);
    lens.zNear = 4.5f;
    options_.extraLights.spheres = {{{0, 0, 0}, 1.33f, kNits, true}};
    const Shape shape = [](const glm::dvec2& place) -> std::optional<Seen> {
        auto outer = ballAt({0, 0, 0}, 1.33f, place);
        if (!outer || outer->height < 0.5) return outer;
        return Seen{-outer->height, outer->normal * glm::dvec3(-1, 1, -1)};
    };
    expect(shape);
    // One-sided, one sees through.
    options_.extraLights.spheres[0].twoSided = false;
    expect([&](const glm::dvec2& place) {
        auto seen = shape(place);
        if (seen && seen->height < -0.5) seen.reset();
        return seen;
    });
}

TEST_F(SeenLightTest, anEllipse) {
    options_.extraLights.ellipses = {{{0.1f, 0, 0.2f}, {1.31f, 0, 0}, {0, 0, -0.72f}, kNits}};
    expect([](const glm::dvec2& place) -> std::optional<Seen> {
        const glm::dvec2 scaled = (place - glm::dvec2(0.1f, 0.2f)) / glm::dvec2(1.31f, 0.72f);
        if (glm::dot(scaled, scaled) > 1.0) return std::nullopt;
        return Seen{0.0, {0, 1, 0}};
    });
}

TEST_F(SeenLightTest, aPicture) {
    PolygonLight light =
        testing::rectangleLight({0.1f, 0, 0.2f}, {1.03f, 0, 0}, {0, 0, -0.72f}, kNits);
    light.texture = testing::makePicture({5, 3}, {-0.93f, 0, -0.52f}, {2.06f, 0, 0}, {0, 0, 1.44f});
    options_.extraLights.polygons = {light};
    const Shape shape = [&](const glm::dvec2& place) -> std::optional<Seen> {
        const glm::dvec2 scaled = (place - glm::dvec2(0.1f, 0.2f)) / glm::dvec2(1.03f, 0.72f);
        if (std::abs(scaled.x) > 1.0 || std::abs(scaled.y) > 1.0) return std::nullopt;
        // From the upper left of the picture to the lower right.
        const glm::dvec3 picture = sampleImage(*light.texture, 0.5 * scaled + 0.5);
        return Seen{0.0, {0, 1, 0}, glm::dvec3(kNits) * picture};
    };
    expect(shape);
    // The same from behind.
    std::ranges::reverse(options_.extraLights.polygons[0].contours[0]);
    options_.extraLights.polygons[0].twoSided = true;
    expect(shape);
}

TEST_F(SeenLightTest, theNearestIsSeen) {
    options_.extraLights.spheres = {{{0, 0, 0}, 1, kNits}};
    options_.extraLights.tubes = {{{0, 0.9f, 0}, {0, 0.9f, 0}, 0.53f, 2.0f * kNits}};
    expect([](const glm::dvec2& place) {
        auto seen = ballAt({0, 0, 0}, 1, place);
        auto other = ballAt({0, 0.9f, 0}, 0.53f, place);
        if (other && other->height > seen->height) {
            seen = other;
            seen->radiance *= 2.0;
        }
        return seen;
    });
}

TEST_F(SeenLightTest, hiddenLightsAreNot) {
    options_.extraLights.spheres = {{{0, 0, 0}, 1, kNits}};
    options_.hideLights = true;
    const FloatImage image = testing::trace(scene_, camera_, options_);
    for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
        ASSERT_EQ(testing::color(image, i), glm::dvec3(kBackground));
    }
}

}  // namespace
}  // namespace polylume::reference
