// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_gizmo_math.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/viewer/light_views.hpp"

namespace polylume::viewer::test {
namespace {

using Kind = GizmoHandle::Kind;

/// Metres that a drag may be off: rounding of the view's matrix in single precision.
constexpr double kTolerance = 2e-4;

Gizmo gizmoOf(GizmoMode mode, const AnyLight& light = rectangleLight(), bool isWorld = false) {
    Gizmo gizmo;
    gizmo.mode = mode;
    gizmo.kind = kindOf(light);
    gizmo.box = boxOf(light);
    gizmo.axes = isWorld ? glm::dmat3(1.0) : gizmo.box.axes;
    return gizmo;
}

glm::dvec2 middleOf(const HandleShape& shape) {
    glm::dvec2 sum(0.0);
    if (shape.handle.kind == Kind::turn) return shape.line[shape.line.size() / 2];
    for (const glm::dvec2& point : shape.line) sum += point;
    return sum / static_cast<double>(shape.line.size());
}

std::vector<ViewTransform> views() {
    return {perspectiveView(), perspectiveView(40.0f), orthographicView()};
}

TEST(LightGizmoTest, everyHandleIsHitAtItsMiddle) {
    for (const ViewTransform& view : views()) {
        for (const GizmoMode mode : {GizmoMode::move, GizmoMode::turn, GizmoMode::resize}) {
            const auto shapes = handleShapes(gizmoOf(mode), view);
            // Move: 3 axes, 3 squares, the middle; turn: 3 rings; resize: 4 edges, 4 corners.
            const std::size_t count = mode == GizmoMode::move ? 7 : mode == GizmoMode::turn ? 3 : 8;
            EXPECT_EQ(shapes.size(), count);
            for (const HandleShape& shape : shapes) {
                EXPECT_EQ(handleAt(shapes, middleOf(shape)), shape.handle)
                    << static_cast<int>(shape.handle.kind) << " " << shape.handle.axis;
            }
            EXPECT_EQ(handleAt(shapes, kPictureOrigin).kind, Kind::none);
        }
        EXPECT_TRUE(handleShapes(gizmoOf(GizmoMode::none), view).empty());
    }
}

TEST(LightGizmoTest, handlesKeepTheirSizeOnTheWindow) {
    // A world axis across the line of sight, near and far.
    const auto lengthAt = [](const glm::dvec3& center, const ViewTransform& view, double scale) {
        Gizmo gizmo = gizmoOf(GizmoMode::move, rectangleLight(), true);
        gizmo.scale = scale;
        gizmo.box.center = center;
        const glm::dvec3 along = view.ray(*view.project(center)).direction;
        gizmo.axes[0] = glm::normalize(glm::cross(along, glm::dvec3(0.0, 1.0, 0.0)));
        for (const HandleShape& shape : handleShapes(gizmo, view)) {
            if (shape.handle == GizmoHandle{Kind::moveAxis, 0}) {
                return glm::length(shape.line[1] - shape.line[0]);
            }
        }
        return 0.0;
    };
    for (const ViewTransform& view : views()) {
        for (const glm::dvec3& center : {glm::dvec3(0.0), {1.0, 1.25, 3.0}, {-4.0, -5.0, -12.0}}) {
            EXPECT_NEAR(lengthAt(center, view, 1.0), 76.0, 1.0);
            EXPECT_NEAR(lengthAt(center, view, 2.0), 152.0, 3.0);
        }
    }
}

TEST(LightGizmoTest, whatPointsAtTheViewerIsLeftOut) {
    const ViewTransform view = perspectiveView();
    Gizmo gizmo = gizmoOf(GizmoMode::move);
    gizmo.box.center = glm::dvec3(0.0);
    const glm::dvec3 z = -view.ray(*view.project(glm::dvec3(0.0))).direction;
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), z));
    gizmo.axes = glm::dmat3(x, glm::cross(z, x), z);
    const auto shapes = handleShapes(gizmo, view);
    const auto has = [&](const GizmoHandle& handle) {
        return std::ranges::any_of(shapes,
                                   [&](const HandleShape& s) { return s.handle == handle; });
    };
    EXPECT_FALSE(has({Kind::moveAxis, 2}));
    EXPECT_TRUE(has({Kind::moveAxis, 0}));
    EXPECT_FALSE(has({Kind::movePlane, 0}));
    EXPECT_TRUE(has({Kind::movePlane, 2}));
    // Behind the camera there is nothing.
    gizmo.box.center = {4.0, 5.0, 12.0};
    EXPECT_TRUE(handleShapes(gizmo, view).empty());
}

TEST(LightGizmoTest, draggingAnAxisFollowsTheMouseAlongIt) {
    for (const ViewTransform& view : views()) {
        const Gizmo gizmo = gizmoOf(GizmoMode::move);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3 grip = gizmo.box.center + 0.5 * gizmo.axes[axis];
            const glm::dvec3 aim = grip + 0.4 * gizmo.axes[axis];
            const GizmoDrag drag{gizmo, {Kind::moveAxis, axis}, *view.project(grip)};
            const LightBox box = dragged(drag, view, *view.project(aim), {});
            const glm::dvec3 offset = glm::transpose(gizmo.axes) * (box.center - gizmo.box.center);
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(offset[i], i == axis ? 0.4 : 0.0, kTolerance) << axis << i;
            }
            EXPECT_EQ(box.half, gizmo.box.half);
            // In tenths of a metre.
            const glm::dvec3 odd = grip + 0.43 * gizmo.axes[axis];
            const LightBox snappedBox = dragged(drag, view, *view.project(odd), {true});
            EXPECT_NEAR(glm::length(snappedBox.center - gizmo.box.center), 0.4, 1e-9);
        }
    }
}

TEST(LightGizmoTest, draggingASquareStaysInItsPlane) {
    for (const ViewTransform& view : views()) {
        const Gizmo gizmo = gizmoOf(GizmoMode::move, rectangleLight(), true);
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 offset(0.3, -0.2, 0.25);
            offset[axis] = 0.0;
            const GizmoDrag drag{gizmo, {Kind::movePlane, axis}, *view.project(gizmo.box.center)};
            const LightBox box = dragged(drag, view, *view.project(gizmo.box.center + offset), {});
            EXPECT_NEAR(glm::length(box.center - gizmo.box.center - offset), 0.0, kTolerance);
            EXPECT_EQ(box.center[axis], gizmo.box.center[axis]);
        }
        // The middle follows the mouse across the picture.
        const glm::dvec2 from = *view.project(gizmo.box.center);
        const GizmoDrag drag{gizmo, {Kind::moveScreen}, from};
        const glm::dvec2 to = from + glm::dvec2(57.0, -31.0);
        EXPECT_NEAR(glm::length(*view.project(dragged(drag, view, to, {}).center) - to), 0.0, 0.1);
    }
}

TEST(LightGizmoTest, draggingARingTurns) {
    for (const ViewTransform& view : views()) {
        const Gizmo gizmo = gizmoOf(GizmoMode::turn);
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3& a = gizmo.axes[(axis + 1) % 3];
            const glm::dvec3& b = gizmo.axes[(axis + 2) % 3];
            const double angle = 0.6;
            const auto at = [&](double turn) {
                return *view.project(gizmo.box.center + std::cos(turn) * a + std::sin(turn) * b);
            };
            const GizmoDrag drag{gizmo, {Kind::turn, axis}, at(0.2)};
            const LightBox box = dragged(drag, view, at(0.2 + angle), {});
            const glm::dmat3 expected =
                glm::mat3_cast(glm::angleAxis(angle, gizmo.axes[axis])) * gizmo.box.axes;
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(glm::length(box.axes[i] - expected[i]), 0.0, kTolerance) << axis;
            }
            EXPECT_EQ(box.center, gizmo.box.center);
            // To the next 15 degrees.
            const LightBox snappedBox = dragged(drag, view, at(0.2 + angle), {true});
            const double cosine =
                glm::dot(snappedBox.axes[(axis + 1) % 3], gizmo.box.axes[(axis + 1) % 3]);
            EXPECT_NEAR(std::acos(cosine), std::numbers::pi / 6.0, 1e-6);
        }
    }
}

TEST(LightGizmoTest, aRingSeenFromTheEdgeTurnsBySliding) {
    const ViewTransform view = orthographicView();
    Gizmo gizmo = gizmoOf(GizmoMode::turn);
    gizmo.box.center = glm::dvec3(0.0);
    const glm::dvec3 z = -view.ray(*view.project(glm::dvec3(0.0))).direction;
    const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), z));
    gizmo.axes = gizmo.box.axes = glm::dmat3(x, glm::cross(z, x), z);
    // Around X, along the window's up: the side before the viewer goes up, and Y with it away.
    const glm::dvec2 middle = *view.project(gizmo.box.center);
    const GizmoDrag drag{gizmo, {Kind::turn, 0}, middle};
    const LightBox box = dragged(drag, view, middle + glm::dvec2(0.0, -84.0), {});
    const double angle = std::acos(std::clamp(glm::dot(box.axes[1], gizmo.axes[1]), -1.0, 1.0));
    EXPECT_NEAR(angle, 1.0, 1e-3) << "the ring's radius is a radian";
    EXPECT_GT(glm::dot(box.axes[2], gizmo.axes[1]), 0.5) << "the front goes with the mouse";
}

TEST(LightGizmoTest, draggingAnEdgeMovesThatEdgeAlone) {
    for (const ViewTransform& view : views()) {
        const Gizmo gizmo = gizmoOf(GizmoMode::resize);
        const LightBox& start = gizmo.box;
        for (int axis = 0; axis < 2; ++axis) {
            for (const int side : {-1, 1}) {
                const glm::dvec3 out = double(side) * start.axes[axis];
                const glm::dvec3 edge = start.center + start.half[axis] * out;
                const GizmoDrag drag{gizmo, {Kind::resize, axis, side}, *view.project(edge)};
                const glm::dvec2 to = *view.project(edge + 0.25 * out);
                const LightBox box = dragged(drag, view, to, {});
                EXPECT_NEAR(box.half[axis], start.half[axis] + 0.125, kTolerance);
                EXPECT_EQ(box.half[1 - axis], start.half[1 - axis]);
                const glm::dvec3 other = box.center - box.half[axis] * out;
                EXPECT_NEAR(glm::length(other - (start.center - start.half[axis] * out)), 0.0,
                            1e-12);
                // With Alt the middle stays; with Shift the other extent follows.
                const LightBox centered = dragged(drag, view, to, {false, false, true});
                EXPECT_EQ(centered.center, start.center);
                EXPECT_NEAR(centered.half[axis], start.half[axis] + 0.25, kTolerance);
                const LightBox kept = dragged(drag, view, to, {false, true, false});
                EXPECT_NEAR(kept.half.x / kept.half.y, start.half.x / start.half.y, 1e-9);
                // Dragged through the other side it is as small as can be, not turned over.
                const LightBox through = dragged(drag, view, *view.project(edge - 3.0 * out), {});
                EXPECT_EQ(through.half[axis], kLeastExtent);
            }
        }
    }
}

TEST(LightGizmoTest, draggingACornerMovesTwoEdges) {
    for (const ViewTransform& view : views()) {
        const Gizmo gizmo = gizmoOf(GizmoMode::resize);
        const LightBox& start = gizmo.box;
        for (const int x : {-1, 1}) {
            for (const int y : {-1, 1}) {
                const glm::dvec3 sides(x, y, 0.0);
                const glm::dvec3 corner = start.center + start.axes * (sides * start.half);
                const glm::dvec3 aim = corner + start.axes * (sides * glm::dvec3(0.2, 0.3, 0.0));
                const GizmoDrag drag{gizmo, {Kind::resizeCorner, 0, x, y}, *view.project(corner)};
                const LightBox box = dragged(drag, view, *view.project(aim), {});
                EXPECT_NEAR(box.half.x, start.half.x + 0.1, kTolerance);
                EXPECT_NEAR(box.half.y, start.half.y + 0.15, kTolerance);
                const glm::dvec3 opposite = box.center - box.axes * (sides * box.half);
                const glm::dvec3 before = start.center - start.axes * (sides * start.half);
                EXPECT_NEAR(glm::length(opposite - before), 0.0, 1e-12);
            }
        }
    }
}

TEST(LightGizmoTest, roundLightsKeepTheirMiddleAndTubesTheirThickness) {
    const ViewTransform view = perspectiveView();
    const auto drag = [&](const AnyLight& light, int axis, double by) {
        const Gizmo gizmo = gizmoOf(GizmoMode::resize, light);
        const glm::dvec3 from = gizmo.box.center + gizmo.box.half[axis] * gizmo.box.axes[axis];
        const glm::dvec3 to = from + by * gizmo.box.axes[axis];
        return dragged({gizmo, {Kind::resize, axis, 1}, *view.project(from)}, view,
                       *view.project(to), {});
    };
    const AnyLight sphere = scene::AreaLight{"", SphereLight{{0.1f, 0.2f, 0.3f}, 0.5f}, ""};
    const LightBox larger = drag(sphere, 1, 0.2);
    EXPECT_NEAR(glm::length(larger.half - glm::dvec3(0.7)), 0.0, kTolerance);
    EXPECT_EQ(larger.center, boxOf(sphere).center);

    const AnyLight tube =
        scene::AreaLight{"", scene::makeTube(obliqueFrame(), 1.0f, 0.1f, glm::vec3(1.0f)), ""};
    const LightBox longer = drag(tube, 0, 0.4);
    EXPECT_NEAR(longer.half.x, 0.8, kTolerance);
    EXPECT_EQ(longer.half.y, boxOf(tube).half.y);
    const LightBox thicker = drag(tube, 1, 0.05);
    EXPECT_NEAR(thicker.half.y, 0.15, kTolerance);
    EXPECT_NEAR(thicker.half.x - thicker.half.y, 0.5, 1e-6) << "between the caps";
    const LightBox ball = drag(tube, 0, -5.0);
    EXPECT_NEAR(ball.half.x, ball.half.y, 1e-9);
}

TEST(LightGizmoTest, turnsInDegreesSayTheAxes) {
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 turn(-90.0 + 180.0 * (i % 7) / 6.0, -170.0 + 34.0 * (i % 11),
                              -160.0 + 23.0 * (i % 13));
        const glm::dmat3 axes = axesOf(turn);
        const glm::dmat3 again = axesOf(turnOf(axes));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(glm::length(axes[k] - again[k]), 0.0, 2e-4) << turn.x << " " << turn.y;
        }
    }
    EXPECT_NEAR(glm::length(turnOf(axesOf({20.0, -50.0, 130.0})) - glm::dvec3(20, -50, 130)), 0.0,
                1e-9);
}

}  // namespace
}  // namespace polylume::viewer::test
