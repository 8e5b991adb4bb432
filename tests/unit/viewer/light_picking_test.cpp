// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_picking.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/viewer/light_views.hpp"

namespace polylume::viewer::test {
namespace {

TEST(ViewTransformTest, projectsWhatARayWentThrough) {
    // Of positions in single precision through a matrix of single precision.
    constexpr double kTolerance = 2e-4;
    for (const ViewTransform& view :
         {perspectiveView(), perspectiveView(40.0f), orthographicView()}) {
        for (const glm::dvec2& mouse : {glm::dvec2(300, 40), {660, 320}, {1050, 600}}) {
            const Ray ray = view.ray(mouse);
            EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
            for (const double distance : {0.5, 3.0, 20.0}) {
                const auto point = view.project(ray.origin + distance * ray.direction);
                ASSERT_TRUE(point.has_value());
                EXPECT_NEAR(glm::length(*point - mouse), 0.0, kTolerance * 800.0);
            }
        }
        const Ray middle = view.ray(view.origin + 0.5 * view.size);
        const glm::dvec3 expected = glm::normalize(glm::dvec3(-2.0, -2.5, -6.0));
        EXPECT_NEAR(glm::length(middle.direction - expected), 0.0, 1e-5);
    }
    const ViewTransform view = perspectiveView();
    EXPECT_FALSE(view.project({4.0, 5.0, 12.0}).has_value()) << "behind the camera";
    EXPECT_FALSE(view.project({1.995, 2.494, 5.985}).has_value()) << "before the near plane";
}

/// A ray at x, y of the frame, from `height` along the frame's -Z, back toward it.
Ray rayAt(const scene::LightFrame& frame, double x, double y) {
    const glm::dmat3 axes(frame.worldFromLight);
    return {glm::dvec3(frame.center) + axes * glm::dvec3(x, y, -3.0), axes[2]};
}

TEST(LightPickingTest, meetsFlatLightsWithinTheirOutline) {
    const scene::LightFrame frame = obliqueFrame();
    const scene::AreaLight rectangle{"", scene::makeRectangle(frame, {2.0f, 1.0f}, {}), ""};
    for (const double x : {-0.99, 0.0, 0.99}) {
        const auto distance = intersect(rayAt(frame, x, 0.49), rectangle);
        ASSERT_TRUE(distance.has_value()) << x;
        EXPECT_NEAR(*distance, 3.0, 1e-6);
    }
    EXPECT_FALSE(intersect(rayAt(frame, 1.01, 0.0), rectangle));
    EXPECT_FALSE(intersect(rayAt(frame, 0.0, -0.51), rectangle));
    Ray away = rayAt(frame, 0.0, 0.0);
    away.direction = -away.direction;
    EXPECT_FALSE(intersect(away, rectangle));

    scene::AreaLight holed = rectangle;
    auto& contours = std::get<PolygonLight>(holed.shape).contours;
    contours.push_back(scene::makeRectangle(frame, {0.5f, 0.5f}, {}).contours[0]);
    std::reverse(contours[1].begin(), contours[1].end());
    EXPECT_FALSE(intersect(rayAt(frame, 0.1, 0.1), holed)) << "the hole";
    EXPECT_TRUE(intersect(rayAt(frame, 0.4, 0.1), holed));

    const scene::AreaLight ellipse{"", scene::makeEllipse(frame, {2.0f, 1.0f}, {}), ""};
    EXPECT_TRUE(intersect(rayAt(frame, 0.69, 0.34), ellipse));
    EXPECT_FALSE(intersect(rayAt(frame, 0.75, 0.36), ellipse));
}

TEST(LightPickingTest, meetsRoundLights) {
    const scene::LightFrame frame = obliqueFrame();
    const scene::AreaLight sphere{"", SphereLight{frame.center, 0.5f}, ""};
    EXPECT_NEAR(*intersect(rayAt(frame, 0.0, 0.0), sphere), 2.5, 1e-6);
    EXPECT_NEAR(*intersect(rayAt(frame, 0.3, 0.0), sphere), 3.0 - 0.4, 1e-6);
    EXPECT_FALSE(intersect(rayAt(frame, 0.36, 0.36), sphere));
    const Ray inside{glm::dvec3(frame.center), {1.0, 0.0, 0.0}};
    EXPECT_NEAR(*intersect(inside, sphere), 0.5, 1e-6);

    const scene::AreaLight tube{"", scene::makeTube(frame, 2.0f, 0.25f, {}), ""};
    EXPECT_NEAR(*intersect(rayAt(frame, 0.9, 0.0), tube), 2.75, 1e-6);
    EXPECT_NEAR(*intersect(rayAt(frame, 0.3, 0.15), tube), 3.0 - 0.2, 1e-6);
    EXPECT_NEAR(*intersect(rayAt(frame, 1.15, 0.0), tube), 3.0 - 0.2, 1e-6) << "the cap";
    EXPECT_FALSE(intersect(rayAt(frame, 1.26, 0.0), tube));
    EXPECT_FALSE(intersect(rayAt(frame, 0.0, 0.26), tube));
    // Along the axis, where the cylinder has no answer.
    const glm::dmat3 axes(frame.worldFromLight);
    const Ray along{glm::dvec3(frame.center) - 4.0 * axes[0], axes[0]};
    EXPECT_NEAR(*intersect(along, tube), 2.75, 1e-6);
}

scene::Scene sceneOfThree() {
    scene::Scene scene;
    scene.areaLights.push_back({"far", SphereLight{{0.0f, 0.0f, 0.0f}, 0.5f}, ""});
    scene.areaLights.push_back({"near", SphereLight{{1.0f, 1.25f, 3.0f}, 0.1f}, ""});
    scene.areaLights.push_back(
        {"line", TubeLight{{-2.0f, 1.0f, 0.0f}, {-1.0f, 1.0f, 0.0f}, 0.001f}, ""});
    scene.punctualLights.push_back({"bulb"});
    scene.punctualLights[0].position = {1.5f, 0.0f, 0.0f};
    return scene;
}

TEST(LightPickingTest, picksTheNearestLight) {
    const scene::Scene scene = sceneOfThree();
    const ViewTransform view = perspectiveView();
    const auto pickAt = [&](const glm::dvec3& position, const glm::dvec2& off = glm::dvec2(0.0)) {
        return pickLight(scene, view, *view.project(position) + off, 14.0);
    };
    const auto area = [](int index) { return LightId{LightId::Kind::area, index}; };
    // The near one covers the far one's middle.
    EXPECT_EQ(pickAt({0.0, 0.0, 0.0}), area(1));
    EXPECT_EQ(pickAt({0.45, 0.0, 0.0}), area(0));
    // Thin as a thread, it is picked from a few pixels off.
    EXPECT_EQ(pickAt({-1.5, 1.0, 0.0}, {0.0, 6.0}), area(2));
    EXPECT_EQ(pickAt({-1.5, 1.0, 0.0}, {0.0, 9.0}), std::nullopt);
    EXPECT_EQ(pickAt({1.5, 0.0, 0.0}, {9.0, 9.0}), (LightId{LightId::Kind::punctual, 0}));
    EXPECT_EQ(pickAt({1.5, 0.0, 0.0}, {11.0, 11.0}), std::nullopt);
    EXPECT_EQ(pickAt({0.0, 2.0, 0.0}), std::nullopt);
}

TEST(LightPickingTest, segmentsBehindTheCameraAreCut) {
    const ViewTransform view = perspectiveView();
    // From the origin to far behind the camera.
    const auto cut = projectSegment(view, {0.0, 0.0, 0.0}, {4.2, 5.0, 12.0});
    ASSERT_TRUE(cut.has_value());
    for (const glm::dvec2& point : *cut) EXPECT_TRUE(std::isfinite(point.x + point.y));
    EXPECT_NEAR(glm::length((*cut)[0] - *view.project({0.0, 0.0, 0.0})), 0.0, 1e-9);
    EXPECT_FALSE(projectSegment(view, {4.2, 5.0, 12.0}, {4.0, 5.0, 13.0}).has_value());
    EXPECT_EQ(distanceToSegment({0.0, 1.0}, {-1.0, 0.0}, {1.0, 0.0}), 1.0);
    EXPECT_EQ(distanceToSegment({4.0, 4.0}, {-1.0, 0.0}, {1.0, 0.0}), 5.0);
    EXPECT_EQ(distanceToSegment({3.0, 4.0}, {0.0, 0.0}, {0.0, 0.0}), 5.0);
}

}  // namespace
}  // namespace polylume::viewer::test
