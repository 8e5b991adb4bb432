// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lights/light_outline.hpp"
#include "reference_scenes.hpp"
#include "support/test_lights.hpp"
#include "support/test_scenes.hpp"

// A Lambert floor under lights that nothing blocks: closed forms.
namespace polylume::reference {
namespace {

constexpr glm::vec3 kAlbedo{0.8f, 0.5f, 0.3f};
constexpr glm::vec3 kNits{1000.0f, 700.0f, 400.0f};
const glm::dvec3 kReflected = glm::dvec3(kAlbedo) * glm::dvec3(kNits);

class LambertFloorTest : public ::testing::Test {
  protected:
    const scene::Scene scene_ =
        testing::sceneOf(test::makeFloor(3.0f), testing::lambertMaterial(kAlbedo));
    const scene::Camera camera_ = test::makeCamera({0.5f, 3.0f, 4.0f}, {0, 0, 0}, 0.7f);
    ReferenceOptions options_ = testing::plainOptions({36, 24}, 2048);

    testing::Agreement compareWithFormFactor(const PolygonLight& light,
                                             const PolygonLight& claimed) {
        options_.extraLights.polygons = {light};
        return testing::compare(testing::trace(scene_, camera_, options_),
                                [&](const glm::dvec3& position, const glm::dvec3&) -> glm::dvec3 {
                                    return testing::formFactor(claimed, position) * kReflected;
                                });
    }
    void expectFormFactor(const PolygonLight& light, const std::string& name) {
        testing::expectAgreement(compareWithFormFactor(light, light), name);
    }
};

/// Facing down, lopsided.
const PolygonLight kRectangle =
    testing::rectangleLight({0.3f, 1.2f, -0.2f}, {0.9f, 0.2f, 0.0f}, {0.0f, 0.0f, 0.6f}, kNits);

/// Stands upright with a quarter of it below the floor, facing +z.
const PolygonLight kUpright =
    testing::rectangleLight({0.0f, 0.5f, -1.5f}, {1.2f, 0, 0}, {0, 1, 0.1f}, kNits);

PolygonLight makeHoledLight(float height) {
    PolygonLight light = test::makeHoledLight(height);
    light.radiance = kNits;
    return light;
}

/// Form factor of a disk of radius r from a patch that is parallel to it, at height h and a beside
/// its axis: (1 - (h^2 + a^2 - r^2) / sqrt((h^2 + a^2 + r^2)^2 - 4 a^2 r^2)) / 2, the contour
/// integral around the disk; on the axis r^2 / (r^2 + h^2) (Howell's catalogue, B-13).
double diskFormFactor(double r, double h, double a) {
    const double sum = h * h + a * a + r * r;
    return 0.5 * (1.0 - (h * h + a * a - r * r) / std::sqrt(sum * sum - 4.0 * a * a * r * r));
}

TEST_F(LambertFloorTest, underARectangle) {
    expectFormFactor(kRectangle, "rectangle");
}

TEST_F(LambertFloorTest, underARectangleByArea) {
    options_.lightSampling = LightSampling::area;
    expectFormFactor(kRectangle, "rectangle by area");
}

TEST_F(LambertFloorTest, underARectangleThatCutsTheFloor) {
    expectFormFactor(kUpright, "cut at the horizon");
}

TEST_F(LambertFloorTest, underAPolygonWithAHole) {
    expectFormFactor(makeHoledLight(1.0f), "polygon with a hole");
}

TEST_F(LambertFloorTest, underATwoSidedLightFromBehind) {
    PolygonLight light = makeHoledLight(1.0f);
    for (auto& contour : light.contours) std::reverse(contour.begin(), contour.end());
    ASSERT_EQ(compareWithFormFactor(light, makeHoledLight(1.0f)).shareWithin4, 0.0);
    light.twoSided = true;
    expectFormFactor(light, "two-sided");
}

TEST_F(LambertFloorTest, underADisk) {
    EllipseLight disk;
    disk.center = {0.4f, 0.8f, -0.3f};
    disk.halfAxisX = {0.0f, 0.0f, 0.7f};
    disk.halfAxisY = {-0.7f, 0.0f, 0.0f};
    disk.radiance = kNits;
    options_.extraLights.ellipses = {disk};
    const FloatImage image = testing::trace(scene_, camera_, options_);
    const auto expected = [&](const glm::dvec3& position, double radius) -> glm::dvec3 {
        const glm::dvec3 offset = glm::dvec3(disk.center) - position;
        return diskFormFactor(radius, offset.y, std::hypot(offset.x, offset.z)) * kReflected;
    };
    const auto withRadius = [&](double radius) {
        return testing::compare(image, [&](const glm::dvec3& position, const glm::dvec3&) {
            return expected(position, radius);
        });
    };
    testing::expectAgreement(withRadius(0.7f), "disk");
    // The twin: a disk that is half a percent larger is found out.
    EXPECT_GT(withRadius(1.005 * 0.7f).relativeMeanError, -0.02);
    EXPECT_LT(withRadius(1.005 * 0.7f).relativeMeanError, -1e-3);
}

TEST_F(LambertFloorTest, underAnEllipse) {
    EllipseLight ellipse;
    ellipse.center = {-0.2f, 0.9f, -0.5f};
    ellipse.halfAxisX = {0.9f, 0.0f, 0.0f};
    ellipse.halfAxisY = {0.0f, -0.2f, 0.3f};
    ellipse.radiance = kNits;
    options_.extraLights.ellipses = {ellipse};
    const FloatImage image = testing::trace(scene_, camera_, options_);
    // Of the ellipse's area: its difference from the ellipse falls with the square of the sides.
    const PolygonLight polygon{{outline(ellipse, 1000)}, kNits};
    const testing::Agreement agreement =
        testing::compare(image, [&](const glm::dvec3& position, const glm::dvec3&) -> glm::dvec3 {
            return testing::formFactor(polygon, position) * kReflected;
        });
    testing::expectAgreement(agreement, "ellipse");
}

TEST_F(LambertFloorTest, theComparisonFindsALightMovedByAHundredth) {
    const PolygonLight light = makeHoledLight(1.0f);
    const testing::Agreement agreement = compareWithFormFactor(light, makeHoledLight(1.01f));
    EXPECT_LT(agreement.shareWithin4, 0.9);
    EXPECT_GT(std::abs(agreement.relativeMeanError), 1e-3);
}

TEST_F(LambertFloorTest, severalLightsAddUp) {
    const PolygonLight first = makeHoledLight(1.0f);
    options_.extraLights.polygons = {first, kUpright};
    const testing::Agreement agreement =
        testing::compare(testing::trace(scene_, camera_, options_),
                         [&](const glm::dvec3& position, const glm::dvec3&) -> glm::dvec3 {
                             return (testing::formFactor(first, position) +
                                     testing::formFactor(kUpright, position)) *
                                    kReflected;
                         });
    testing::expectAgreement(agreement, "two lights");
}

TEST_F(LambertFloorTest, underLightsWithoutExtent) {
    // No estimates: exact but for rounding.
    PunctualLight point;
    point.position = {0.5f, 1.5f, -0.3f};
    point.intensity = kNits;
    PunctualLight sun;
    sun.kind = PunctualLightKind::directional;
    sun.direction = glm::normalize(glm::vec3(0.3f, -1.0f, 0.2f));
    sun.intensity = kNits;
    PunctualLight spot = point;
    spot.kind = PunctualLightKind::spot;
    spot.direction = glm::normalize(glm::vec3(-0.2f, -1.0f, 0.1f));
    spot.innerConeAngle = 0.3f;
    spot.outerConeAngle = 0.6f;
    const auto ofPoint = [&](const glm::dvec3& position) {
        const glm::dvec3 offset = glm::dvec3(point.position) - position;
        const double square = glm::dot(offset, offset);
        return offset.y / std::sqrt(square) / square / std::numbers::pi;
    };
    const auto ofSpot = [&](const glm::dvec3& position) {
        // KHR_lights_punctual: the square of the angle's share between the cones' cosines.
        const glm::dvec3 away = glm::normalize(position - glm::dvec3(point.position));
        const double cosine = glm::dot(away, glm::dvec3(spot.direction));
        const double inner = std::cos(0.3), outer = std::cos(0.6);
        const double share = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
        return ofPoint(position) * share * share;
    };
    const auto ofSun = [&](const glm::dvec3&) {
        return -static_cast<double>(sun.direction.y) / std::numbers::pi;
    };
    using Form = std::function<double(const glm::dvec3&)>;
    const std::vector<std::pair<PunctualLight, Form>> lights = {
        {point, ofPoint}, {spot, ofSpot}, {sun, ofSun}};
    for (const auto& [light, form] : lights) {
        options_.extraLights.punctuals = {light};
        const FloatImage image = testing::trace(scene_, camera_, options_);
        std::size_t surfaceCount = 0;
        for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
            if (testing::layer(image, "normal", i) == glm::dvec3(0.0)) continue;
            ++surfaceCount;
            const double factor = form(testing::layer(image, "position", i));
            for (int c = 0; c < 3; ++c) {
                const double expected = factor * kReflected[c];
                // Positions and directions in single precision; the spot's border is steep.
                ASSERT_NEAR(testing::color(image, i)[c], expected, 1e-5 * expected + 1e-4);
            }
            ASSERT_EQ(testing::layer(image, "standardError", i), glm::dvec3(0.0));
        }
        EXPECT_GT(surfaceCount, 500u);
    }
}

}  // namespace
}  // namespace polylume::reference
