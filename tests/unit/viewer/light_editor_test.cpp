// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_editor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "light_editor_shapes.hpp"
#include "light_gizmo_math.hpp"
#include "unit/viewer/imgui_fixture.hpp"

namespace polylume::viewer::test {
namespace {

constexpr LightId kPanelLight{LightId::Kind::area, 0};
constexpr LightId kBall{LightId::Kind::area, 1};
constexpr LightId kBulb{LightId::Kind::punctual, 0};

class LightEditorTest : public LightEditorFixture {
  protected:
    LightBox box(int index = 0) const {
        return boxOf(scene_.areaLights[static_cast<std::size_t>(index)]);
    }

    /// Where the handle is on the window.
    glm::dvec2 handle(GizmoMode mode, const GizmoHandle& wanted, int index = 0) const {
        const AnyLight light = scene_.areaLights[static_cast<std::size_t>(index)];
        const Gizmo gizmo{mode, kindOf(light), boxOf(light), boxOf(light).axes, 1.0};
        for (const HandleShape& shape : handleShapes(gizmo, view_)) {
            if (!(shape.handle == wanted)) continue;
            glm::dvec2 sum(0.0);
            for (const glm::dvec2& point : shape.line) sum += point;
            return sum / static_cast<double>(shape.line.size());
        }
        ADD_FAILURE() << "no such handle";
        return {};
    }
};

TEST_F(LightEditorTest, clicksSelectLights) {
    EXPECT_FALSE(editor_.selected().has_value());
    click(pixelOf(box(0).center));
    EXPECT_EQ(editor_.selected(), kPanelLight);
    click(pixelOf({-1.2, 0.6, 0.0}));
    EXPECT_EQ(editor_.selected(), kBall);
    click(pixelOf({1.6, 0.3, 0.0}));
    EXPECT_EQ(editor_.selected(), kBulb);
    click(kPictureOrigin + 5.0);
    EXPECT_FALSE(editor_.selected().has_value());
    EXPECT_FALSE(editor_.hasUnsavedChanges());
}

TEST_F(LightEditorTest, theListSelectsLights) {
    // Down the list, row by row, each light is met.
    std::vector<LightId> met;
    for (double y = 20.0; y < 200.0; y += 4.0) {
        moveMouse({120.0, y});
        pressMouse(true);
        pressMouse(false);
        const auto selected = editor_.selected();
        if (selected && (met.empty() || met.back() != *selected)) met.push_back(*selected);
        if (met.size() == 3) break;
    }
    ASSERT_EQ(met.size(), 3u);
    EXPECT_EQ(met[0], kPanelLight);
    EXPECT_EQ(met[1], kBall);
    EXPECT_EQ(met[2], kBulb);
}

TEST_F(LightEditorTest, draggingAnArrowMovesTheLightAlongIt) {
    editor_.select(kPanelLight);
    frame();
    const LightBox before = box();
    // 60 pixels along the arrow, and half a metre on.
    const double grip = 60.0 * worldPerUnit(view_, before.center);
    const glm::dvec2 from = pixelOf(before.center + grip * before.axes[0]);
    const glm::dvec2 to = pixelOf(before.center + (grip + 0.5) * before.axes[0]);
    moveMouse(from);
    EXPECT_TRUE(editor_.wantsMouse());
    EXPECT_TRUE(drag(from, to));
    const glm::dvec3 offset = glm::transpose(before.axes) * (box().center - before.center);
    // Dear ImGui rounds the mouse to whole pixels, at both ends.
    EXPECT_NEAR(offset.x, 0.5, 2.0 * worldPerUnit(view_, before.center));
    EXPECT_NEAR(offset.y, 0.0, 1e-5);
    EXPECT_NEAR(offset.z, 0.0, 1e-5);
    EXPECT_EQ(kindOf(scene_.areaLights[0]), LightKind::rectangle);
    EXPECT_TRUE(editor_.hasUnsavedChanges());
    EXPECT_FALSE(editor_.isDragging());
    EXPECT_EQ(scene_.areaLights[1].name, "ball");
    EXPECT_EQ(boxOf(scene_.areaLights[1]).center, glm::dvec3(glm::vec3(-1.2f, 0.6f, 0.0f)));
}

TEST_F(LightEditorTest, draggingAnEdgeResizesAndARingTurns) {
    editor_.select(kPanelLight);
    press('3');
    const LightBox before = box();
    const glm::dvec2 edge = handle(GizmoMode::resize, {GizmoHandle::Kind::resize, 0, 1});
    const glm::dvec2 out = edge - pixelOf(before.center);
    EXPECT_TRUE(drag(edge, edge + out));
    EXPECT_GT(box().half.x, 1.3 * before.half.x);
    EXPECT_NEAR(box().half.y, before.half.y, 1e-6);

    press('2');
    const LightBox wide = box();
    const GizmoHandle ring{GizmoHandle::Kind::turn, 2};
    const Gizmo gizmo{GizmoMode::turn, LightKind::rectangle, wide, wide.axes, 1.0};
    for (const HandleShape& shape : handleShapes(gizmo, view_)) {
        if (!(shape.handle == ring)) continue;
        EXPECT_TRUE(drag(shape.line[10], shape.line[30]));
    }
    EXPECT_LT(glm::dot(box().axes[0], wide.axes[0]), 0.9);
    EXPECT_NEAR(glm::dot(box().axes[2], wide.axes[2]), 1.0, 1e-5);
    EXPECT_NEAR(glm::length(box().half - wide.half), 0.0, 1e-6);
    // Without handles a drag is the camera's.
    press('4');
    const LightBox turned = box();
    EXPECT_FALSE(drag(pixelOf(turned.center), pixelOf(turned.center) + 40.0));
}

TEST_F(LightEditorTest, escapePutsADraggedLightBack) {
    editor_.select(kPanelLight);
    frame();
    const LightBox before = box();
    const glm::dvec2 from = handle(GizmoMode::move, {GizmoHandle::Kind::moveAxis, 1});
    moveMouse(from);
    pressMouse(true);
    EXPECT_TRUE(moveMouse(from + glm::dvec2(0.0, 60.0)) || moveMouse(from + glm::dvec2(60.0, 0.0)));
    EXPECT_TRUE(editor_.isDragging());
    EXPECT_NE(box().center, before.center);
    EXPECT_TRUE(press(kEscape));
    EXPECT_EQ(box().center, before.center);
    pressMouse(false);
    EXPECT_FALSE(editor_.hasUnsavedChanges());
    EXPECT_EQ(editor_.selected(), kPanelLight);
    press(kEscape);
    EXPECT_FALSE(editor_.selected().has_value());
}

TEST_F(LightEditorTest, undoAndRedoGoStepByStep) {
    editor_.select(kPanelLight);
    frame();
    const glm::dvec3 first = box().center;
    const auto move = [&] {
        const glm::dvec2 at = pixelOf(box().center);
        EXPECT_TRUE(drag(at, at + glm::dvec2(30.0, 20.0)));
        return box().center;
    };
    const glm::dvec3 second = move();
    const glm::dvec3 third = move();
    EXPECT_TRUE(press('Z', true));
    EXPECT_EQ(box().center, second);
    EXPECT_TRUE(press('Z', true));
    EXPECT_EQ(box().center, first);
    EXPECT_FALSE(editor_.hasUnsavedChanges());
    EXPECT_FALSE(press('Z', true));
    EXPECT_TRUE(press('Z', true, true));
    EXPECT_TRUE(press('Y', true));
    EXPECT_EQ(box().center, third);
    EXPECT_FALSE(press('Y', true));
    // Saved here: going back is a change, and coming again is none.
    editor_.markSaved();
    EXPECT_FALSE(editor_.hasUnsavedChanges());
    press('Z', true);
    EXPECT_TRUE(editor_.hasUnsavedChanges());
    press('Y', true);
    EXPECT_FALSE(editor_.hasUnsavedChanges());
}

TEST_F(LightEditorTest, keysDuplicateAndDelete) {
    editor_.select(kBall);
    EXPECT_TRUE(press('D', true));
    ASSERT_EQ(scene_.areaLights.size(), 3u);
    EXPECT_EQ(editor_.selected(), (LightId{LightId::Kind::area, 2}));
    EXPECT_EQ(scene_.areaLights[2].name, "ball copy");
    EXPECT_EQ(box(2).half, box(1).half);
    EXPECT_NE(box(2).center, box(1).center);
    EXPECT_TRUE(press(kDelete));
    EXPECT_EQ(scene_.areaLights.size(), 2u);
    EXPECT_TRUE(press(kDelete));
    EXPECT_TRUE(press(kDelete));
    EXPECT_TRUE(scene_.areaLights.empty());
    EXPECT_FALSE(press(kDelete)) << "nothing is selected";
    for (int i = 0; i < 4; ++i) press('Z', true);
    ASSERT_EQ(scene_.areaLights.size(), 2u);
    EXPECT_EQ(scene_.areaLights[1].name, "ball");
    editor_.select(kBulb);
    EXPECT_TRUE(press(kDelete));
    EXPECT_TRUE(scene_.punctualLights.empty());
}

TEST_F(LightEditorTest, fieldsOfThePanelChangeTheLight) {
    // Drags on everything in the panel below the list: some fields change the light, each by a step
    // that can be undone, and it stays a light.
    editor_.select(kPanelLight);
    frame();
    const std::vector<scene::AreaLight> before = scene_.areaLights;
    int changeCount = 0;
    for (double y = 110.0; y < 420.0; y += 7.0) {
        if (drag({60.0, y}, {95.0, y})) ++changeCount;
        press(kEscape);
        editor_.select(kPanelLight);
        for (const scene::AreaLight& light : scene_.areaLights) {
            if (const auto* polygon = std::get_if<PolygonLight>(&light.shape)) {
                ASSERT_NO_THROW(checkLights({{*polygon}, {}})) << y;
            }
        }
    }
    EXPECT_GE(changeCount, 5) << "place, turn, size, intensity ...";
    int undoCount = 0;
    while (press('Z', true)) ++undoCount;
    EXPECT_GE(undoCount, 5);
    const auto& shape = std::get<PolygonLight>(scene_.areaLights[0].shape);
    EXPECT_EQ(shape.contours, std::get<PolygonLight>(before[0].shape).contours);
    EXPECT_EQ(shape.radiance, std::get<PolygonLight>(before[0].shape).radiance);
}

TEST_F(LightEditorTest, thePanelKeepsTheMouseForItself) {
    // The light is moved to where its handles lie below the panel.
    editor_.select(kPanelLight);
    view_.origin.x = -270.0;
    frame();
    const glm::dvec2 at = pixelOf(box().center);
    ASSERT_LT(at.x, kPanelWidth);
    moveMouse(at);
    moveMouse(at);
    EXPECT_FALSE(editor_.wantsMouse());
}

TEST_F(LightEditorTest, anotherSceneIsMetWithoutAMemory) {
    editor_.select(kBall);
    press(kDelete);
    scene_ = {};
    editor_.reset();
    EXPECT_FALSE(frame());
    EXPECT_FALSE(press('Z', true));
    EXPECT_TRUE(scene_.areaLights.empty());
    EXPECT_FALSE(editor_.hasUnsavedChanges());
    // A selection that is kept ends where its light does.
    scene_.areaLights.push_back(rectangleLight());
    editor_.reset(true);
    editor_.select(kBall);
    frame();
    EXPECT_FALSE(editor_.selected().has_value());
}

TEST_F(LightEditorTest, boundsOfTheSelectedLightHoldIt) {
    EXPECT_FALSE(editor_.selectedBounds(scene_).has_value());
    editor_.select(kBall);
    const auto bounds = editor_.selectedBounds(scene_);
    ASSERT_TRUE(bounds.has_value());
    EXPECT_NEAR(bounds->minimum.x, -1.5f, 1e-6f);
    EXPECT_NEAR(bounds->maximum.y, 0.9f, 1e-6f);
    editor_.select(kBulb);
    EXPECT_GT(editor_.selectedBounds(scene_)->radius(), 0.1f);
}

}  // namespace
}  // namespace polylume::viewer::test
