// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "reference/area_emitter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference_scenes.hpp"

namespace polylume::reference {
namespace {

PolygonLight rectangle(const glm::vec3& center, const glm::vec3& x, const glm::vec3& y) {
    return testing::rectangleLight(center, x, y, glm::vec3(1.0f));
}

/// A picture of 2 x 1 texels, red and green.
LightTexture twoTexels(const glm::vec3& origin, const glm::vec3& axisU, const glm::vec3& axisV) {
    const auto image = std::make_shared<LightImage>();
    image->size = {2, 1};
    image->texels = {{1, 0, 0}, {0, 1, 0}};
    return {image, origin, axisU, axisV};
}

Ray rayTo(const glm::dvec3& from, const glm::dvec3& to) {
    Ray ray;
    ray.origin = from;
    ray.direction = to - from;
    return ray;
}

TEST(AreaEmitterTest, lightsWithoutAreaAreLeftOut) {
    LightSet lights;
    lights.polygons = {rectangle({0, 0, 1}, {1, 0, 0}, {2, 0, 0})};
    lights.ellipses = {{{0, 0, 1}, {1, 0, 0}, {0, 0, 0}}};
    lights.spheres = {{{0, 0, 1}, 0.0f}};
    lights.tubes = {{{0, 0, 1}, {1, 0, 1}, 0.0f}};
    EXPECT_TRUE(areaEmitters(lights).empty());
    lights.polygons.push_back(rectangle({0, 0, 1}, {1, 0, 0}, {0, 2, 0}));
    lights.tubes.push_back({{0, 0, 1}, {0, 0, 1}, 0.5f});
    const std::vector<AreaEmitter> emitters = areaEmitters(lights);
    ASSERT_EQ(emitters.size(), 2u);
    EXPECT_NEAR(std::get<FlatEmitter>(emitters[0]).area, 8.0, 1e-12);
    EXPECT_EQ(std::get<FlatEmitter>(emitters[0]).shape, FlatEmitter::Shape::rectangle);
    EXPECT_NEAR(std::get<SolidEmitter>(emitters[1]).area(), std::numbers::pi, 1e-12);
}

TEST(AreaEmitterTest, aBentRectangleIsAPolygon) {
    const PolygonLight light = rectangle({0, 0, 1}, {1, 0, 0}, {0.01f, 2, 0});
    EXPECT_EQ(flatEmitter(light).shape, FlatEmitter::Shape::polygon);
    EXPECT_NEAR(flatEmitter(light).area, 8.0, 1e-6);
}

TEST(AreaEmitterTest, aPictureLiesWhereItsAxesSay) {
    // The rectangle and, bent, a polygon; the axes are not at right angles.
    for (const float bend : {0.0f, 0.3f}) {
        PolygonLight light = rectangle({0, 0, 1}, {1, 0, 0}, {bend, 1, 0});
        light.radiance = {10, 20, 30};
        light.texture = twoTexels({-1, -1, 1}, {2, 0, 0}, {0.5f, 2, 0});
        const AreaEmitter emitter = flatEmitter(light);
        std::mt19937 generator(1);
        std::uniform_real_distribution<double> unit(-0.9, 0.9);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 point(0.6 * unit(generator), unit(generator), 1.0);
            const auto hit = intersect(emitter, rayTo({0.1, 0.2, 5}, point));
            ASSERT_TRUE(hit);
            const double v = (point.y + 1.0) / 2.0, u = (point.x + 1.0 - 0.5 * v) / 2.0;
            const double green = std::clamp(2.0 * u - 0.5, 0.0, 1.0);
            EXPECT_LT(glm::length(hit->radiance - glm::dvec3(10 * (1 - green), 20 * green, 0)),
                      1e-6);
        }
    }
}

TEST(AreaEmitterTest, aPictureIsMirroredFromBehind) {
    PolygonLight light = rectangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    light.texture = twoTexels({-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
    const glm::dvec3 left(-0.9, 0, 0);
    AreaEmitter emitter = flatEmitter(light);
    EXPECT_EQ(intersect(emitter, rayTo({0, 0, 3}, left))->radiance, glm::dvec3(1, 0, 0));
    EXPECT_FALSE(intersect(emitter, rayTo({0, 0, -3}, left)));
    light.twoSided = true;
    emitter = flatEmitter(light);
    EXPECT_EQ(intersect(emitter, rayTo({0, 0, -3}, left))->radiance, glm::dvec3(1, 0, 0));
    EXPECT_EQ(intersect(emitter, rayTo({0, 0, -3}, left))->normal, glm::dvec3(0, 0, -1));
}

TEST(AreaEmitterTest, raysMeetASphereOutside) {
    SphereLight light{{1, 2, 3}, 0.5f, glm::vec3(7.0f)};
    AreaEmitter emitter = solidEmitter(light);
    const auto hit = intersect(emitter, rayTo({1, 2, 13}, {1, 2, 8}));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 9.5 / 5.0, 1e-14);
    EXPECT_EQ(hit->normal, glm::dvec3(0, 0, 1));
    EXPECT_EQ(hit->radiance, glm::dvec3(7.0));
    EXPECT_FALSE(intersect(emitter, rayTo({1, 2, 13}, {1, 2, 20})));
    EXPECT_FALSE(intersect(emitter, rayTo({1.51, 2, 13}, {1.51, 2, 0})));
    Ray near = rayTo({1, 2, 13}, {1, 2, 12});
    near.nearest = 9.7;
    EXPECT_FALSE(intersect(emitter, near));
    near.nearest = 0.0;
    near.farthest = 9.4;
    EXPECT_FALSE(intersect(emitter, near));
    // From inside there is nothing, unless it shines inwards.
    EXPECT_FALSE(intersect(emitter, rayTo({1, 2, 3}, {1, 2, 4})));
    light.twoSided = true;
    emitter = solidEmitter(light);
    const auto inner = intersect(emitter, rayTo({1, 2, 3.1}, {1, 2, 4.1}));
    ASSERT_TRUE(inner);
    EXPECT_NEAR(inner->distance, 0.4, 1e-14);
    EXPECT_EQ(inner->normal, glm::dvec3(0, 0, -1));
}

TEST(AreaEmitterTest, raysMeetATubeWhereItIsItsRadiusFromTheAxis) {
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto random = [&] {
        const double x = unit(generator), y = unit(generator);
        return glm::dvec3(x, y, unit(generator));
    };
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        SolidEmitter tube{random(), 2.0 * random(), 0.3 + 0.2 * unit(generator)};
        if (i % 3 == 0) tube.axis = glm::dvec3(0.0);
        const glm::dvec3 direction = glm::normalize(random());
        tube.start += 2.0 * random();
        const auto distance = [&](double t) {
            SolidEmitter moved = tube;
            moved.start -= t * direction;
            return glm::length(moved.nearestOfAxis());
        };
        const std::optional<Chord> chord = tube.chord(direction);
        // The distance from a segment is convex along a line: thirds to the least.
        double low = -20.0, high = 20.0;
        for (int k = 0; k < 150; ++k) {
            const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
            (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
        }
        const double least = distance(low);
        if (std::abs(least - tube.radius) < 1e-7) continue;
        ASSERT_EQ(chord.has_value(), least < tube.radius);
        if (!chord) continue;
        ++hits;
        ASSERT_LE(chord->enter, chord->leave);
        // Ends are as sharp as the surface is steep.
        ASSERT_NEAR(distance(chord->enter), tube.radius, 1e-9);
        ASSERT_NEAR(distance(chord->leave), tube.radius, 1e-9);
    }
    EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace polylume::reference
