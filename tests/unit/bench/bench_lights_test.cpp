// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/bench_lights.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace polylume::bench {
namespace {

std::size_t countOf(const LightSet& lights) {
    return lights.polygons.size() + lights.ellipses.size() + lights.spheres.size() +
           lights.tubes.size();
}

TEST(BenchLightsTest, everyShapeIsValidAndAsMany) {
    for (const ShapeInfo& shape : kShapes) {
        const LightSet lights = makeLights(shape.shape, 5);
        EXPECT_NO_THROW(checkLights(lights)) << shape.name;
        EXPECT_EQ(countOf(lights), 5u) << shape.name;
        EXPECT_EQ(infoOf(shape.shape).name, shape.name);
    }
}

TEST(BenchLightsTest, polygonsHaveTheEdgesThatAreCounted) {
    for (const ShapeInfo& shape : kShapes) {
        if (shape.edgeCount == 0) continue;
        const PolygonLight light = makeLights(shape.shape, 1).polygons.at(0);
        std::size_t edges = 0;
        for (const auto& contour : light.contours) edges += contour.size();
        EXPECT_EQ(edges, static_cast<std::size_t>(shape.edgeCount)) << shape.name;
        EXPECT_EQ(light.contours.size(), static_cast<std::size_t>(shape.contourCount));
    }
}

TEST(BenchLightsTest, theFloorCutsSomeLightsAndLeavesOthers) {
    int cut = 0;
    int whole = 0;
    for (const PolygonLight& light : makeLights(Shape::rectangle, 16).polygons) {
        const auto height = [](const glm::vec3& vertex) { return vertex.y; };
        const auto [low, high] = std::ranges::minmax(light.contours[0], {}, height);
        EXPECT_GT(high.y, 0.0f);
        (low.y < 0.0f ? cut : whole) += 1;
    }
    EXPECT_GE(cut, 2);
    EXPECT_GE(whole, 2);
}

TEST(BenchLightsTest, modelsAreWhatTheirNamesSay) {
    EXPECT_EQ(lightingModel(Model::twoLobes).quality, Quality::high);
    EXPECT_EQ(lightingModel(Model::burley).quality, Quality::standard);
    EXPECT_EQ(lightingModel(Model::burley).diffuse, Diffuse::burley);
    EXPECT_FALSE(makeFloorScene(Model::oneLobe).hasSheen());
    EXPECT_TRUE(makeFloorScene(Model::sheen).hasSheen());
    EXPECT_TRUE(makeFloorScene(Model::everything).hasSheen());
}

}  // namespace
}  // namespace polylume::bench
