// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reference_scenes.hpp"
#include "support/test_lights.hpp"
#include "support/test_scenes.hpp"

// A Lambert floor under balls and tubes: closed forms and line integrals.
namespace polylume::reference {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr glm::vec3 kAlbedo{0.8f, 0.5f, 0.3f};
constexpr glm::vec3 kNits{1000.0f, 700.0f, 400.0f};
const glm::dvec3 kReflected = glm::dvec3(kAlbedo) * glm::dvec3(kNits);

/// From a point of the floor.
using FormFactor = std::function<double(const glm::dvec3& position)>;

class RoundFloorTest : public ::testing::Test {
  protected:
    const scene::Scene scene_ =
        testing::sceneOf(test::makeFloor(3.0f), testing::lambertMaterial(kAlbedo));
    const scene::Camera camera_ = test::makeCamera({0.5f, 3.0f, 4.0f}, {0, 0, 0}, 0.7f);
    ReferenceOptions options_ = testing::plainOptions({36, 24}, 2048);

    testing::Agreement compare(const FormFactor& formFactor) {
        return testing::compare(testing::trace(scene_, camera_, options_),
                                [&](const glm::dvec3& position, const glm::dvec3&) -> glm::dvec3 {
                                    return formFactor(position) * kReflected;
                                });
    }
    void expect(const FormFactor& formFactor, const std::string& name) {
        for (const LightSampling sampling : {LightSampling::solidAngle, LightSampling::area}) {
            options_.lightSampling = sampling;
            testing::expectAgreement(compare(formFactor),
                                     name + (sampling == LightSampling::area ? " by area" : ""));
        }
    }
};

/// Form factor of a ball that the floor may cut: where all of it is above, sin^2 of the half angle
/// times the cosine; else the integral over the disk that is seen as its closed form (Howell's
/// catalogue, B-43, with all lengths over the radius).
double sphereFormFactor(const SphereLight& light, const glm::dvec3& position) {
    const glm::dvec3 offset = glm::dvec3(light.center) - position;
    const double distance = glm::length(offset);
    const double h = distance / light.radius;
    const double cosine = offset.y / distance;
    const double theta = std::acos(cosine);
    if (h * cosine >= 1.0) return cosine / (h * h);
    if (h * cosine <= -1.0) return 0.0;
    const double root = std::sqrt(h * h - 1.0);
    const double across = std::sqrt(1.0 - h * h * cosine * cosine);
    return (cosine * std::acos(-root / std::tan(theta)) - root * across) / (kPi * h * h) +
           std::atan(across / root) / kPi;
}

TEST_F(RoundFloorTest, underASphere) {
    const SphereLight sphere{{0.3f, 1.1f, -0.4f}, 0.6f, kNits};
    options_.extraLights.spheres = {sphere};
    const auto form = [&](const glm::dvec3& p) { return sphereFormFactor(sphere, p); };
    expect(form, "sphere");
    // The twin: half a percent larger.
    SphereLight larger = sphere;
    larger.radius *= 1.005f;
    const testing::Agreement twin =
        compare([&](const glm::dvec3& p) { return sphereFormFactor(larger, p); });
    EXPECT_LT(twin.relativeMeanError, -5e-3);
}

TEST_F(RoundFloorTest, underASphereThatCutsTheFloor) {
    for (const float height : {0.2f, 0.0f, -0.3f}) {
        const SphereLight sphere{{0.3f, height, -0.9f}, 0.6f, kNits};
        options_.extraLights.spheres = {sphere};
        expect(
            [&](const glm::dvec3& p) {
                const bool isInside = glm::length(p - glm::dvec3(sphere.center)) < sphere.radius;
                return isInside ? 0.0 : sphereFormFactor(sphere, p);
            },
            "sphere at " + std::to_string(height));
    }
}

TEST_F(RoundFloorTest, aTubeWithoutLengthIsASphere) {
    const SphereLight sphere{{0.3f, 0.2f, -0.4f}, 0.6f, kNits};
    options_.extraLights.tubes = {{sphere.center, sphere.center, sphere.radius, kNits}};
    expect(
        [&](const glm::dvec3& p) {
            const bool isInside = glm::length(p - glm::dvec3(sphere.center)) < sphere.radius;
            return isInside ? 0.0 : sphereFormFactor(sphere, p);
        },
        "tube without length");
}

TEST_F(RoundFloorTest, insideAnInwardLightAllIsAlbedo) {
    // The whole floor is inside.
    options_.extraLights.spheres = {{{0.2f, 1.0f, 0.1f}, 8.0f, kNits, true}};
    expect([](const glm::dvec3&) { return 1.0; }, "in a sphere");
    options_.extraLights = {};
    options_.extraLights.tubes = {{{-3, 0.5f, 0}, {3, 1.0f, 0.2f}, 7.0f, kNits, true}};
    expect([](const glm::dvec3&) { return 1.0; }, "in a tube");
    // One-sided, black.
    options_.extraLights.tubes[0].twoSided = false;
    options_.extraLights.spheres = {{{0.2f, 1.0f, 0.1f}, 8.0f, kNits, false}};
    const FloatImage image = testing::trace(scene_, camera_, options_);
    for (std::size_t i = 0; i < image.pixels.size() / image.channelCount(); ++i) {
        ASSERT_EQ(testing::color(image, i), glm::dvec3(0.0));
    }
}

/// Of a thin tube beside a floor point: per length a disk's projected area, 2 r sin to the axis.
/// The integral over the line by Simpson's rule.
double lineFormFactor(const TubeLight& light, const glm::dvec3& position) {
    constexpr int kSteps = 2000;
    const glm::dvec3 axis = glm::dvec3(light.end) - glm::dvec3(light.start);
    const double length = glm::length(axis);
    double sum = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const glm::dvec3 offset =
            glm::dvec3(light.start) + static_cast<double>(i) / kSteps * axis - position;
        const double square = glm::dot(offset, offset), distance = std::sqrt(square);
        const double sine = glm::length(glm::cross(offset, axis)) / (distance * length);
        const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
        sum += weight * std::max(offset.y, 0.0) / distance * sine / square;
    }
    return sum * length / (3.0 * kSteps) * 2.0 * light.radius / kPi;
}

TEST_F(RoundFloorTest, aThinTubeIsALine) {
    // Caps and curvature are a part r / length and (r / distance)^2 of the light. The thinner ones
    // take the way for small solid angles.
    for (const float radius : {1e-4f, 1e-6f, 1e-9f}) {
        const TubeLight tube{{-1.2f, 0.7f, -0.3f}, {0.9f, 1.1f, 0.4f}, radius, kNits};
        options_.extraLights.tubes = {tube};
        options_.lightSampling = LightSampling::solidAngle;
        testing::expectAgreement(
            compare([&](const glm::dvec3& p) { return lineFormFactor(tube, p); }),
            "radius " + std::to_string(radius));
    }
}

}  // namespace
}  // namespace polylume::reference
