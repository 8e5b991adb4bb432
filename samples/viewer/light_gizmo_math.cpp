// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_gizmo_math.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "light_picking.hpp"

namespace polylume::viewer {
namespace {

using Kind = GizmoHandle::Kind;

// Sizes in pixels of a plain display.
constexpr double kAxisStart = 16.0;
constexpr double kAxisEnd = 92.0;
constexpr double kPlaneStart = 22.0;
constexpr double kPlaneEnd = 42.0;
constexpr double kRingRadius = 84.0;
constexpr double kResizeGap = 14.0;  ///< Off the light's edge, so that a small one's stay apart.
constexpr double kKnob = 8.0;        ///< Half a square that is taken hold of.
constexpr double kLineReach = 7.0;
/// Shorter on the window, an axis points at the viewer.
constexpr double kShortestAxis = 28.0;
/// Nearer to the light's middle than twice this, two resize handles could not be told apart.
constexpr double kClosest = 3.5;
/// Cosine to the line of sight below which a square is seen from the edge.
constexpr double kEdgeOn = 0.12;
constexpr int kRingSides = 96;

/// From a position to the viewer.
glm::dvec3 towardViewer(const ViewTransform& view, const glm::dvec3& position) {
    const auto point = view.project(position);
    return point ? -view.ray(*point).direction : glm::dvec3(0.0);
}

HandleShape knobAt(const GizmoHandle& handle, const glm::dvec2& center, double scale) {
    const double half = kKnob * scale;
    return {handle,
            {center + glm::dvec2(-half, -half), center + glm::dvec2(half, -half),
             center + glm::dvec2(half, half), center + glm::dvec2(-half, half)},
            true,
            0.25 * half};
}

void addMoveHandles(const Gizmo& gizmo, const ViewTransform& view, const glm::dvec2& center,
                    double unit, std::vector<HandleShape>& shapes) {
    const glm::dvec3 viewer = towardViewer(view, gizmo.box.center);
    // What lies on top comes first.
    HandleShape middle = knobAt({Kind::moveScreen}, center, gizmo.scale);
    shapes.push_back(middle);
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(glm::dot(gizmo.axes[axis], viewer)) < kEdgeOn) continue;
        const glm::dvec3& a = gizmo.axes[(axis + 1) % 3];
        const glm::dvec3& b = gizmo.axes[(axis + 2) % 3];
        HandleShape square{{Kind::movePlane, axis}, {}, true, 0.0};
        for (const glm::dvec2& corner : {glm::dvec2(kPlaneStart, kPlaneStart),
                                         {kPlaneEnd, kPlaneStart},
                                         {kPlaneEnd, kPlaneEnd},
                                         {kPlaneStart, kPlaneEnd}}) {
            const auto point =
                view.project(gizmo.box.center + unit * (corner.x * a + corner.y * b));
            if (point) square.line.push_back(*point);
        }
        if (square.line.size() == 4) shapes.push_back(std::move(square));
    }
    for (int axis = 0; axis < 3; ++axis) {
        const auto start = view.project(gizmo.box.center + unit * kAxisStart * gizmo.axes[axis]);
        const auto end = view.project(gizmo.box.center + unit * kAxisEnd * gizmo.axes[axis]);
        if (!start || !end || glm::length(*end - center) < kShortestAxis * gizmo.scale) continue;
        shapes.push_back({{Kind::moveAxis, axis}, {*start, *end}, false, kLineReach * gizmo.scale});
    }
}

void addTurnHandles(const Gizmo& gizmo, const ViewTransform& view, double unit,
                    std::vector<HandleShape>& shapes) {
    const glm::dvec3 viewer = towardViewer(view, gizmo.box.center);
    for (int axis = 0; axis < 3; ++axis) {
        // Turning a tube around itself does nothing.
        const glm::dvec3& n = gizmo.axes[axis];
        if (gizmo.kind == LightKind::tube && std::abs(glm::dot(n, gizmo.box.axes[0])) > 0.999) {
            continue;
        }
        const glm::dvec3& a = gizmo.axes[(axis + 1) % 3];
        const glm::dvec3& b = gizmo.axes[(axis + 2) % 3];
        HandleShape ring{{Kind::turn, axis}, {}, false, kLineReach * gizmo.scale};
        // The nearer half; all of a ring that is seen from the front. It starts at the far side, so
        // that the points that are left hang together.
        const double startAngle =
            std::atan2(glm::dot(b, viewer), glm::dot(a, viewer)) + std::numbers::pi;
        const bool isWhole = std::abs(glm::dot(n, viewer)) > 0.95;
        for (int i = 0; i <= kRingSides; ++i) {
            const double angle = startAngle + 2.0 * std::numbers::pi * i / kRingSides;
            const glm::dvec3 arm = std::cos(angle) * a + std::sin(angle) * b;
            if (!isWhole && glm::dot(arm, viewer) < -0.02) continue;
            const auto point = view.project(gizmo.box.center + unit * kRingRadius * arm);
            if (point) ring.line.push_back(*point);
        }
        if (ring.line.size() > 1) shapes.push_back(std::move(ring));
    }
}

void addResizeHandles(const Gizmo& gizmo, const ViewTransform& view, double unit,
                      std::vector<HandleShape>& shapes) {
    const LightBox& box = gizmo.box;
    const double gap = kResizeGap * unit;
    if (isFlat(gizmo.kind)) {
        for (const int side : {-1, 1}) {
            for (const int otherSide : {-1, 1}) {
                const auto point = view.project(
                    box.center + box.axes * glm::dvec3(side * (box.half.x + gap),
                                                       otherSide * (box.half.y + gap), 0.0));
                if (!point) continue;
                shapes.push_back(
                    knobAt({Kind::resizeCorner, 0, side, otherSide}, *point, gizmo.scale));
            }
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!(box.half[axis] > 0.0)) continue;
        for (const int side : {-1, 1}) {
            const glm::dvec3 arm = double(side) * (box.half[axis] + gap) * box.axes[axis];
            const auto point = view.project(box.center + arm);
            const auto inner = view.project(box.center + 0.5 * arm);
            if (!point || !inner) continue;
            // Two handles at one place can't be told apart.
            if (glm::length(*point - *inner) < kClosest * gizmo.scale) continue;
            shapes.push_back(knobAt({Kind::resize, axis, side, 1}, *point, gizmo.scale));
        }
    }
}

bool isInside(const std::vector<glm::dvec2>& outline, const glm::dvec2& point) {
    bool inside = false;
    for (std::size_t i = 0, k = outline.size() - 1; i < outline.size(); k = i++) {
        const glm::dvec2 &a = outline[i], &b = outline[k];
        if ((a.y > point.y) == (b.y > point.y)) continue;
        if (a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) > point.x) inside = !inside;
    }
    return inside;
}

/// How far along the axis through `origin` the mouse is: where the two lines are nearest.
std::optional<double> alongAxis(const ViewTransform& view, const glm::dvec2& mouse,
                                const glm::dvec3& origin, const glm::dvec3& axis) {
    const Ray ray = view.ray(mouse);
    const double cosine = glm::dot(axis, ray.direction);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < 1e-4) return std::nullopt;
    const glm::dvec3 offset = ray.origin - origin;
    return (glm::dot(axis, offset) - cosine * glm::dot(ray.direction, offset)) / sine2;
}

std::optional<glm::dvec3> onPlane(const ViewTransform& view, const glm::dvec2& mouse,
                                  const glm::dvec3& origin, const glm::dvec3& normal) {
    const Ray ray = view.ray(mouse);
    const double slope = glm::dot(ray.direction, normal);
    if (std::abs(slope) < 1e-3) return std::nullopt;
    const double distance = glm::dot(origin - ray.origin, normal) / slope;
    if (distance < 0.0) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

double snapped(double value, double step, bool snap) {
    return snap ? step * std::round(value / step) : value;
}

constexpr double kSnapMetres = 0.1;
constexpr double kSnapRadians = std::numbers::pi / 12.0;

/// The angle around an axis that the mouse has gone from where the drag began.
double turnedAngle(const GizmoDrag& drag, const ViewTransform& view, const glm::dvec2& mouse) {
    const Gizmo& start = drag.start;
    const glm::dvec3& n = start.axes[drag.handle.axis];
    const glm::dvec3& center = start.box.center;
    const glm::dvec3 viewer = towardViewer(view, center);
    if (std::abs(glm::dot(n, viewer)) > 0.2) {
        const auto from = onPlane(view, drag.mouse, center, n);
        const auto to = onPlane(view, mouse, center, n);
        if (!from || !to) return 0.0;
        const glm::dvec3 a = *from - center, b = *to - center;
        return std::atan2(glm::dot(n, glm::cross(a, b)), glm::dot(a, b));
    }
    // From the edge a ring is a line: along it, its radius is a radian.
    const auto middle = view.project(center);
    const double unit = worldPerUnit(view, center);
    const glm::dvec3 along = glm::cross(n, viewer);
    if (!middle || !(unit > 0.0) || !(glm::length(along) > 0.0)) return 0.0;
    const auto tip = view.project(center + unit * glm::normalize(along));
    if (!tip) return 0.0;
    const glm::dvec2 direction = *tip - *middle;
    return glm::dot(mouse - drag.mouse, direction) / (kRingRadius * start.scale);
}

LightBox movedBox(const GizmoDrag& drag, const ViewTransform& view, const glm::dvec2& mouse,
                  const DragOptions& options) {
    LightBox box = drag.start.box;
    const glm::dmat3& axes = drag.start.axes;
    if (drag.handle.kind == Kind::moveAxis) {
        const glm::dvec3& axis = axes[drag.handle.axis];
        const auto from = alongAxis(view, drag.mouse, box.center, axis);
        const auto to = alongAxis(view, mouse, box.center, axis);
        if (from && to) box.center += snapped(*to - *from, kSnapMetres, options.snap) * axis;
        return box;
    }
    const bool isScreen = drag.handle.kind == Kind::moveScreen;
    // Across the line of sight in the middle of the picture, as the picture is.
    const glm::dvec3 normal =
        isScreen ? view.ray(view.origin + 0.5 * view.size).direction : axes[drag.handle.axis];
    const auto from = onPlane(view, drag.mouse, box.center, normal);
    const auto to = onPlane(view, mouse, box.center, normal);
    if (!from || !to) return box;
    glm::dvec3 offset = glm::transpose(axes) * (*to - *from);
    for (int i = 0; i < 3; ++i) offset[i] = snapped(offset[i], kSnapMetres, options.snap);
    if (!isScreen) offset[drag.handle.axis] = 0.0;
    box.center += axes * offset;
    return box;
}

/// Moves one side of the box out by `offset`, with or without the other.
void stretch(LightBox& box, int axis, int side, double offset, const DragOptions& options) {
    const double before = box.half[axis];
    const double change = options.fromCenter ? offset : 0.5 * offset;
    box.half[axis] = std::max(kLeastExtent, before + change);
    if (!options.fromCenter) {
        box.center += double(side) * (box.half[axis] - before) * box.axes[axis];
    }
}

LightBox resizedBox(const GizmoDrag& drag, const ViewTransform& view, const glm::dvec2& mouse,
                    const DragOptions& options) {
    const Gizmo& start = drag.start;
    LightBox box = start.box;
    const GizmoHandle& handle = drag.handle;
    const bool isCorner = handle.kind == Kind::resizeCorner;
    glm::dvec3 offset(0.0);
    if (isCorner) {
        const auto from = onPlane(view, drag.mouse, box.center, box.axes[2]);
        const auto to = onPlane(view, mouse, box.center, box.axes[2]);
        if (!from || !to) return box;
        offset = glm::transpose(box.axes) * (*to - *from) *
                 glm::dvec3(handle.side, handle.otherSide, 0.0);
    } else {
        const auto from = alongAxis(view, drag.mouse, box.center, box.axes[handle.axis]);
        const auto to = alongAxis(view, mouse, box.center, box.axes[handle.axis]);
        if (!from || !to) return box;
        offset[handle.axis] = handle.side * (*to - *from);
    }
    for (int i = 0; i < 3; ++i) offset[i] = snapped(offset[i], kSnapMetres, options.snap);

    const bool isRound = start.kind == LightKind::sphere;
    const bool isThickness = start.kind == LightKind::tube && handle.axis != 0;
    if (isRound || isThickness) {
        // The radius; the middle stays.
        const double radius = std::max(kLeastExtent, box.half[handle.axis] + offset[handle.axis]);
        if (isRound) {
            box.half = glm::dvec3(radius);
        } else {
            // As long as before between the caps.
            box.half.x += radius - box.half.y;
            box.half.y = box.half.z = radius;
        }
        return box;
    }
    if (start.kind == LightKind::tube) {
        // Not shorter than a ball.
        const double least = 2.0 * (box.half.y - box.half.x);
        offset.x = std::max(offset.x, options.fromCenter ? 0.5 * least : least);
    }
    if (options.keepShape && isFlat(start.kind)) {
        // By the larger of the two changes.
        const double most = options.fromCenter ? 1.0 : 0.5;
        const double x = 1.0 + most * offset.x / box.half.x;
        const double y = 1.0 + most * offset.y / box.half.y;
        const double factor = std::max(1e-3, std::abs(x - 1.0) > std::abs(y - 1.0) ? x : y);
        offset.x = (factor - 1.0) * box.half.x / most;
        offset.y = (factor - 1.0) * box.half.y / most;
        stretch(box, 0, isCorner || handle.axis == 0 ? handle.side : 0, offset.x, options);
        stretch(box, 1,
                isCorner           ? handle.otherSide
                : handle.axis == 1 ? handle.side
                                   : 0,
                offset.y, options);
        return box;
    }
    if (isCorner || handle.axis == 0) stretch(box, 0, handle.side, offset.x, options);
    if (isCorner) {
        stretch(box, 1, handle.otherSide, offset.y, options);
    } else if (handle.axis != 0) {
        stretch(box, handle.axis, handle.side, offset[handle.axis], options);
    }
    return box;
}

}  // namespace

double worldPerUnit(const ViewTransform& view, const glm::dvec3& positionWorld) {
    const auto point = view.project(positionWorld);
    if (!point) return 0.0;
    const glm::dvec3 forward = view.ray(view.origin + 0.5 * view.size).direction;
    const auto atDepth = [&](const glm::dvec2& mouse) {
        const Ray ray = view.ray(mouse);
        const double depth = glm::dot(positionWorld - ray.origin, forward);
        return ray.origin + depth / glm::dot(ray.direction, forward) * ray.direction;
    };
    return glm::length(atDepth(*point + glm::dvec2(0.0, 1.0)) - atDepth(*point));
}

std::vector<HandleShape> handleShapes(const Gizmo& gizmo, const ViewTransform& view) {
    std::vector<HandleShape> shapes;
    const auto center = view.project(gizmo.box.center);
    const double unit = gizmo.scale * worldPerUnit(view, gizmo.box.center);
    if (!center || !(unit > 0.0)) return shapes;
    switch (gizmo.mode) {
        case GizmoMode::none:
            break;
        case GizmoMode::move:
            addMoveHandles(gizmo, view, *center, unit, shapes);
            break;
        case GizmoMode::turn:
            if (hasDirection(gizmo.kind)) addTurnHandles(gizmo, view, unit, shapes);
            break;
        case GizmoMode::resize:
            addResizeHandles(gizmo, view, unit, shapes);
            break;
    }
    return shapes;
}

GizmoHandle handleAt(const std::vector<HandleShape>& shapes, const glm::dvec2& mouse) {
    for (const HandleShape& shape : shapes) {
        if (shape.isArea && isInside(shape.line, mouse)) return shape.handle;
    }
    GizmoHandle found;
    double nearest = INFINITY;
    for (const HandleShape& shape : shapes) {
        const std::size_t count = shape.line.size();
        for (std::size_t i = 1; i < count; ++i) {
            const double distance = distanceToSegment(mouse, shape.line[i - 1], shape.line[i]);
            if (distance > shape.reach || !(distance < nearest)) continue;
            nearest = distance;
            found = shape.handle;
        }
    }
    return found;
}

LightBox dragged(const GizmoDrag& drag, const ViewTransform& view, const glm::dvec2& mouse,
                 const DragOptions& options) {
    switch (drag.handle.kind) {
        case Kind::none:
            break;
        case Kind::moveAxis:
        case Kind::movePlane:
        case Kind::moveScreen:
            return movedBox(drag, view, mouse, options);
        case Kind::turn: {
            const double angle =
                snapped(turnedAngle(drag, view, mouse), kSnapRadians, options.snap);
            const glm::dvec3& axis = drag.start.axes[drag.handle.axis];
            LightBox box = drag.start.box;
            box.axes = glm::mat3_cast(glm::angleAxis(angle, axis)) * box.axes;
            // Rounding does not add up: each drag starts from the frame before it.
            box.axes = glm::mat3_cast(glm::normalize(glm::quat_cast(box.axes)));
            return box;
        }
        case Kind::resize:
        case Kind::resizeCorner:
            return resizedBox(drag, view, mouse, options);
    }
    return drag.start.box;
}

glm::dvec3 turnOf(const glm::dmat3& axes) {
    // R = Ry Rx Rz.
    const double x = std::asin(std::clamp(-axes[2].y, -1.0, 1.0));
    if (std::abs(axes[2].y) > 1.0 - 1e-9) {
        // Looking straight up or down, the other two turn around the same line.
        return glm::degrees(glm::dvec3(x, std::atan2(-axes[0].z, axes[0].x), 0.0));
    }
    return glm::degrees(
        glm::dvec3(x, std::atan2(axes[2].x, axes[2].z), std::atan2(axes[0].y, axes[1].y)));
}

glm::dmat3 axesOf(const glm::dvec3& turnDegrees) {
    const glm::dvec3 turn = glm::radians(turnDegrees);
    const auto around = [](double angle, int axis) {
        glm::dvec3 unit(0.0);
        unit[axis] = 1.0;
        return glm::angleAxis(angle, unit);
    };
    return glm::mat3_cast(
        glm::normalize(around(turn.y, 1) * around(turn.x, 0) * around(turn.z, 2)));
}

}  // namespace polylume::viewer
