// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_editor_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "lights/light_outline.hpp"
#include "scene/flat_frame.hpp"
#include "unit/viewer/light_views.hpp"

namespace polylume::viewer::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Rounding of coordinates about 1.
constexpr double kTolerance = 1e-6;

std::vector<AnyLight> everyKind() {
    const AnyLight rectangle = rectangleLight();
    const glm::dmat3 axes = boxOf(rectangle).axes;
    std::vector<AnyLight> lights;
    for (const LightKind kind : kLightKinds) lights.push_back(converted(rectangle, kind, axes));
    return lights;
}

void expectBox(const LightBox& found, const LightBox& wanted, const char* what) {
    EXPECT_NEAR(glm::length(found.center - wanted.center), 0.0, kTolerance) << what;
    EXPECT_NEAR(glm::length(found.half - wanted.half), 0.0, kTolerance) << what;
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(glm::length(found.axes[i] - wanted.axes[i]), 0.0, kTolerance) << what << i;
    }
}

TEST(LightShapesTest, boxesSayWhatMadeTheLight) {
    const scene::LightFrame frame = obliqueFrame();
    const glm::dmat3 axes(frame.worldFromLight);
    const glm::dvec3 center(frame.center);
    const auto box = [&](auto shape, const glm::dmat3& hint = glm::dmat3(1.0)) {
        return boxOf(scene::AreaLight{"", shape, ""}, hint);
    };
    expectBox(box(scene::makeRectangle(frame, {2.0f, 1.0f}, {})), {center, axes, {1.0, 0.5, 0.0}},
              "rectangle");
    expectBox(box(scene::makeEllipse(frame, {2.0f, 1.0f}, {})), {center, axes, {1.0, 0.5, 0.0}},
              "ellipse");
    expectBox(box(scene::makeTube(frame, 2.0f, 0.1f, {}), axes), {center, axes, {1.1, 0.1, 0.1}},
              "tube");
    expectBox(box(SphereLight{frame.center, 0.25f}, axes), {center, axes, glm::dvec3(0.25)},
              "sphere");
    scene::PunctualLight spot;
    spot.type = scene::PunctualLightType::spot;
    spot.position = frame.center;
    spot.direction = -frame.worldFromLight[2];
    expectBox(boxOf(spot, axes), {center, axes, glm::dvec3(0.0)}, "spot");
}

TEST(LightShapesTest, everyKindIsWhatItIsCalled) {
    const std::vector<AnyLight> lights = everyKind();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        EXPECT_EQ(kindOf(lights[i]), kLightKinds[i]);
        EXPECT_EQ(nameOf(lights[i]), "panel");
        LightSet set;
        if (const auto* area = std::get_if<scene::AreaLight>(&lights[i])) {
            if (const auto* polygon = std::get_if<PolygonLight>(&area->shape)) {
                set.polygons.push_back(*polygon);
            }
        }
        EXPECT_NO_THROW(checkLights(set)) << nameOf(kLightKinds[i]);
    }
}

TEST(LightShapesTest, movingTheBoxMovesTheLight) {
    const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
    for (const AnyLight& light : everyKind()) {
        const char* const what = nameOf(kindOf(light));
        const LightBox from = boxOf(light, glm::dmat3(obliqueFrame().worldFromLight));
        LightBox to = from;
        to.center += glm::dvec3(0.3, -0.2, 0.9);
        to.axes = glm::mat3_cast(turn) * from.axes;
        const AnyLight result = moved(light, from, to);
        EXPECT_EQ(kindOf(result), kindOf(light)) << what;
        LightBox expected = to;
        const LightBox found = boxOf(result, to.axes);
        if (kindOf(light) == LightKind::point) expected.axes = found.axes;
        expectBox(found, expected, what);
        EXPECT_EQ(emissionOf(result), emissionOf(light)) << what;
        // And back.
        expectBox(boxOf(moved(result, to, from), from.axes), from, what);
    }
}

TEST(LightShapesTest, resizingChangesTheExtentsAlone) {
    for (const LightKind kind : {LightKind::rectangle, LightKind::polygon, LightKind::ellipse}) {
        const AnyLight light = converted(rectangleLight(), kind, boxOf(rectangleLight()).axes);
        const LightBox from = boxOf(light);
        LightBox to = from;
        to.half = {0.9, 0.2, 0.0};
        expectBox(boxOf(moved(light, from, to)), to, nameOf(kind));
        // Never to nothing. A needle's axes are said by an edge of a tenth of a millimetre, whose
        // ends are rounded.
        to.half = {0.9, 0.0, 0.0};
        const double thickness = boxOf(moved(light, from, to)).half.y;
        EXPECT_GT(thickness, 0.9 * kLeastExtent);
        EXPECT_LT(thickness, 10.0 * kLeastExtent);
    }
}

TEST(LightShapesTest, aRectangleStaysOneHoweverOftenItIsMoved) {
    AnyLight light = rectangleLight();
    const LightBox first = boxOf(light);
    for (int i = 0; i < 1000; ++i) {
        const LightBox from = boxOf(light);
        LightBox to = from;
        to.axes = glm::mat3_cast(glm::angleAxis(0.1, glm::dvec3(0.6, 0.8, 0.0))) * from.axes;
        to.center.x += i % 2 == 0 ? 0.01 : -0.01;
        light = moved(light, from, to);
        ASSERT_EQ(kindOf(light), LightKind::rectangle) << i;
    }
    EXPECT_NEAR(glm::length(boxOf(light).half - first.half), 0.0, 1e-4);
}

TEST(LightShapesTest, aPictureGoesWithItsLight) {
    scene::AreaLight light = rectangleLight();
    const auto image = std::make_shared<LightImage>();
    setPicture(light, image, boxOf(light));
    const LightBox from = boxOf(light);
    LightBox to = from;
    to.center += glm::dvec3(1.0, 2.0, 3.0);
    to.half *= 2.0;
    const AnyLight result = moved(light, from, to);
    scene::AreaLight expected = std::get<scene::AreaLight>(result);
    setPicture(expected, image, to);
    const auto& found = *std::get<PolygonLight>(std::get<scene::AreaLight>(result).shape).texture;
    const auto& wanted = *std::get<PolygonLight>(expected.shape).texture;
    EXPECT_NEAR(glm::length(found.origin - wanted.origin), 0.0, kTolerance);
    EXPECT_NEAR(glm::length(found.axisU - wanted.axisU), 0.0, kTolerance);
    EXPECT_NEAR(glm::length(found.axisV - wanted.axisV), 0.0, kTolerance);
    EXPECT_EQ(pictureOf(result), image);
    // Upright: v runs down the light's Y, and u to the right of who looks at its front.
    EXPECT_LT(glm::dot(glm::dvec3(wanted.axisV), to.axes[1]), 0.0);
    EXPECT_LT(glm::dot(glm::dvec3(wanted.axisU), to.axes[0]), 0.0);
    EXPECT_EQ(pictureOf(converted(result, LightKind::polygon, to.axes)), image);
    EXPECT_EQ(pictureOf(converted(result, LightKind::sphere, to.axes)), nullptr);
}

TEST(LightShapesTest, anotherKindIsAboutAsLargeAndAsStrong) {
    const AnyLight rectangle = rectangleLight();
    const LightBox box = boxOf(rectangle);
    const double flux = *fluxOf(rectangle);
    // pi L A, by luminance.
    const double luminance = 900.0 * 0.2126 + 600.0 * 0.7152 + 300.0 * 0.0722;
    EXPECT_NEAR(flux, kPi * luminance * 1.2 * 0.7, 1e-3 * flux);
    for (const AnyLight& light : everyKind()) {
        const LightKind kind = kindOf(light);
        const LightBox found = boxOf(light, box.axes);
        EXPECT_NEAR(glm::length(found.center - box.center), 0.0, kTolerance) << nameOf(kind);
        if (kind != LightKind::tube) {
            EXPECT_NEAR(glm::length(found.axes[2] - box.axes[2]), 0.0, 1e-5) << nameOf(kind);
        }
        if (isArea(kind)) {
            EXPECT_NEAR(found.half.x, kind == LightKind::sphere ? 0.6 : box.half.x, kTolerance);
        }
        if (isFlat(kind)) {
            EXPECT_NEAR(*fluxOf(light), flux, 1e-4 * flux) << nameOf(kind);
        }
        // To the front as bright as before: L A.
        const double axial = 900.0 * 1.2 * 0.7;
        if (kind == LightKind::point || kind == LightKind::spot) {
            EXPECT_NEAR(emissionOf(light).r, axial, 1e-3 * axial);
        }
        if (kind == LightKind::sphere) {
            EXPECT_NEAR(emissionOf(light).r * kPi * 0.36, axial, 1e-3 * axial);
        }
        // And back again.
        const AnyLight back = converted(light, LightKind::rectangle, found.axes);
        EXPECT_EQ(kindOf(back), LightKind::rectangle);
        if (isFlat(kind)) {
            EXPECT_NEAR(emissionOf(back).r, 900.0, 0.1) << nameOf(kind);
        }
    }
}

TEST(LightShapesTest, polygonsHaveTheCornersAskedFor) {
    const scene::AreaLight light = rectangleLight();
    const LightBox box = boxOf(light);
    for (int corners = 3; corners <= 24; ++corners) {
        const scene::AreaLight polygon = withCorners(light, corners, box);
        const auto& shape = std::get<PolygonLight>(polygon.shape);
        EXPECT_EQ(shape.contours[0].size(), static_cast<std::size_t>(corners));
        EXPECT_NO_THROW(checkLights({{shape}, {}}));
        const glm::dvec3 front = glm::normalize(areaVector(shape.contours[0]));
        EXPECT_NEAR(glm::dot(front, -box.axes[2]), 1.0, 1e-6) << corners;
        expectBox(boxOf(polygon), box, "polygon");
    }
    // With four corners it is the rectangle again.
    EXPECT_EQ(kindOf(withCorners(light, 4, box)), LightKind::rectangle);
}

TEST(LightShapesTest, aRectangleIsToldFromOtherOutlines) {
    const auto rectangle = std::get<PolygonLight>(rectangleLight().shape);
    EXPECT_TRUE(scene::rectangleOf(rectangle).has_value());
    for (int i = 0; i < 4; ++i) {
        PolygonLight bent = rectangle;
        bent.contours[0][static_cast<std::size_t>(i)] += glm::vec3(1e-3f, 0.0f, 0.0f);
        EXPECT_FALSE(scene::rectangleOf(bent).has_value()) << i;
    }
    PolygonLight sheared = rectangle;
    const glm::vec3 shift = 0.01f * (sheared.contours[0][1] - sheared.contours[0][0]);
    sheared.contours[0][2] += shift;
    sheared.contours[0][3] += shift;
    EXPECT_FALSE(scene::rectangleOf(sheared).has_value());
}

}  // namespace
}  // namespace polylume::viewer::test
