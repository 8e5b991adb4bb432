// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "light_gizmo.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/log.hpp"
#include "core/text.hpp"
#include "image/srgb.hpp"
#include "light_picking.hpp"
#include "lights/plane_axes.hpp"

namespace polylume::viewer {
namespace {

using Kind = GizmoHandle::Kind;

constexpr ImU32 kAxisColors[] = {IM_COL32(236, 88, 84, 255), IM_COL32(122, 199, 88, 255),
                                 IM_COL32(84, 148, 240, 255)};
constexpr ImU32 kNeutral = IM_COL32(235, 235, 235, 255);
constexpr ImU32 kHot = IM_COL32(255, 214, 82, 255);
constexpr ImU32 kAccent = IM_COL32(255, 178, 64, 255);
constexpr ImU32 kShadow = IM_COL32(0, 0, 0, 130);

ImVec2 imVec(const glm::dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

ImU32 faded(ImU32 color, double share) {
    const auto alpha = static_cast<ImU32>(share * (color >> IM_COL32_A_SHIFT & 0xFF));
    return (color & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

/// A line that is seen on any ground.
void drawLine(ImDrawList& list, const glm::dvec2& a, const glm::dvec2& b, ImU32 color,
              double width) {
    list.AddLine(imVec(a), imVec(b), faded(kShadow, (color >> IM_COL32_A_SHIFT & 0xFF) / 255.0),
                 static_cast<float>(width + 2.0));
    list.AddLine(imVec(a), imVec(b), color, static_cast<float>(width));
}

void drawPolyline(ImDrawList& list, const std::vector<glm::dvec2>& line, ImU32 color,
                  double width) {
    std::vector<ImVec2> points;
    for (const glm::dvec2& point : line) points.push_back(imVec(point));
    const int count = static_cast<int>(points.size());
    list.AddPolyline(points.data(), count, faded(kShadow, 1.0), 0, static_cast<float>(width + 2.0));
    list.AddPolyline(points.data(), count, color, 0, static_cast<float>(width));
}

void drawArrow(ImDrawList& list, const glm::dvec2& from, const glm::dvec2& to, ImU32 color,
               double width, double head) {
    const glm::dvec2 along = to - from;
    const double length = glm::length(along);
    if (!(length > 1.0)) return;
    const glm::dvec2 unit = along / length;
    const glm::dvec2 across(-unit.y, unit.x);
    const glm::dvec2 neck = to - std::min(head, length) * unit;
    drawLine(list, from, neck, color, width);
    list.AddTriangleFilled(imVec(to), imVec(neck + 0.42 * head * across),
                           imVec(neck - 0.42 * head * across), color);
}

ImU32 colorOf(const GizmoHandle& handle) {
    const bool isNeutral = handle.kind == Kind::moveScreen || handle.kind == Kind::resizeCorner;
    return isNeutral ? kNeutral : kAxisColors[handle.axis];
}

void drawHandle(ImDrawList& list, const HandleShape& shape, bool isHot, double scale) {
    const ImU32 color = isHot ? kHot : colorOf(shape.handle);
    const double width = (isHot ? 4.0 : 3.0) * scale;
    if (shape.handle.kind == Kind::moveAxis) {
        drawArrow(list, shape.line[0], shape.line[1], color, width, 15.0 * scale);
    } else if (shape.handle.kind == Kind::turn) {
        drawPolyline(list, shape.line, color, width);
    } else if (shape.handle.kind == Kind::movePlane) {
        list.AddQuadFilled(imVec(shape.line[0]), imVec(shape.line[1]), imVec(shape.line[2]),
                           imVec(shape.line[3]), faded(color, isHot ? 0.7 : 0.35));
        list.AddQuad(imVec(shape.line[0]), imVec(shape.line[1]), imVec(shape.line[2]),
                     imVec(shape.line[3]), color, static_cast<float>(1.5 * scale));
    } else {
        // What is taken hold of is larger than what is seen.
        const glm::dvec2 center = 0.5 * (shape.line[0] + shape.line[2]);
        const double half = (isHot ? 6.5 : 5.5) * scale;
        const auto rounding =
            static_cast<float>(shape.handle.kind == Kind::moveScreen ? half : 1.5 * scale);
        const ImVec2 low = imVec(center - half), high = imVec(center + half);
        list.AddRectFilled({low.x - 1.5f, low.y - 1.5f}, {high.x + 1.5f, high.y + 1.5f}, kShadow,
                           rounding + 1.5f);
        list.AddRectFilled(low, high, color, rounding);
    }
}

/// A light's hue at full brightness, so that dark ones are found as well.
ImU32 hueOf(const AnyLight& light) {
    const glm::vec3 emission = emissionOf(light);
    const float most = std::max({emission.r, emission.g, emission.b});
    const glm::vec3 hue = most > 0.0f ? emission / most : glm::vec3(1.0f);
    const auto code = [](float linear) {
        return static_cast<int>(255.0f * srgbFromLinear(std::clamp(linear, 0.0f, 1.0f)) + 0.5f);
    };
    return IM_COL32(code(hue.r), code(hue.g), code(hue.b), 255);
}

void drawOutline(ImDrawList& list, const ViewTransform& view, const scene::AreaLight& light,
                 ImU32 color, double width) {
    for (const auto& line : outlineOf(light)) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const auto segment = projectSegment(view, line[i - 1], line[i]);
            if (segment) drawLine(list, (*segment)[0], (*segment)[1], color, width);
        }
    }
}

/// Where a light shines to, from its middle.
void drawDirection(ImDrawList& list, const ViewTransform& view, const LightBox& box, ImU32 color,
                   double scale) {
    const double unit = scale * worldPerUnit(view, box.center);
    if (!(unit > 0.0)) return;
    const auto from = view.project(box.center);
    const auto to = view.project(box.center - 46.0 * unit * box.axes[2]);
    // Toward the viewer it says nothing.
    if (!from || !to || glm::length(*to - *from) < 14.0 * scale) return;
    drawArrow(list, *from, *to, color, 2.0 * scale, 9.0 * scale);
}

/// The edge of a spot's cone, some way along it.
void drawCone(ImDrawList& list, const ViewTransform& view, const scene::PunctualLight& light,
              ImU32 color, double scale) {
    const glm::dvec3 apex(light.position);
    const double length = 90.0 * scale * worldPerUnit(view, apex);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(light.direction));
    const PlaneAxes<double> plane(axis);
    // A cone as wide as a half space has its edge in a plane.
    const double angle = light.outerConeAngle;
    std::optional<glm::dvec3> previous;
    constexpr int kSides = 32;
    for (int i = 0; i <= kSides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kSides;
        const glm::dvec3 arm = std::cos(turn) * plane.x + std::sin(turn) * plane.y;
        const glm::dvec3 point = apex + length * (std::cos(angle) * axis + std::sin(angle) * arm);
        const auto draw = [&](const glm::dvec3& a, const glm::dvec3& b) {
            const auto segment = projectSegment(view, a, b);
            if (segment) drawLine(list, (*segment)[0], (*segment)[1], color, 1.5 * scale);
        };
        if (previous) draw(*previous, point);
        if (i % 8 == 0) draw(apex, point);
        previous = point;
    }
}

/// A small sun.
void drawPunctualMark(ImDrawList& list, const glm::dvec2& center, ImU32 fill, ImU32 color,
                      double scale) {
    list.AddCircleFilled(imVec(center), static_cast<float>(7.0 * scale), kShadow);
    list.AddCircleFilled(imVec(center), static_cast<float>(5.0 * scale), fill);
    list.AddCircle(imVec(center), static_cast<float>(6.0 * scale), color, 0,
                   static_cast<float>(1.5 * scale));
    for (int i = 0; i < 8; ++i) {
        const double angle = std::numbers::pi * i / 4.0;
        const glm::dvec2 arm(std::cos(angle), std::sin(angle));
        drawLine(list, center + 9.0 * scale * arm, center + 12.0 * scale * arm, color, 1.5 * scale);
    }
}

}  // namespace

double interfaceScale() {
    // ImGui's own font is 13 pixels high.
    return ImGui::GetFontSize() / 13.0;
}

void drawLightMark(ImDrawList& list, const ViewTransform& view, const AnyLight& light,
                   LightMark mark) {
    const double scale = interfaceScale();
    const ImU32 color = mark == LightMark::selected  ? kAccent
                        : mark == LightMark::hovered ? kNeutral
                                                     : faded(kNeutral, 0.6);
    const LightKind kind = kindOf(light);
    if (const auto* area = std::get_if<scene::AreaLight>(&light)) {
        if (mark == LightMark::plain) return;
        drawOutline(list, view, *area, mark == LightMark::selected ? color : faded(color, 0.6),
                    (mark == LightMark::selected ? 2.0 : 1.5) * scale);
        if (mark == LightMark::selected && isFlat(kind)) {
            drawDirection(list, view, boxOf(light), color, scale);
        }
        return;
    }
    const auto& punctual = std::get<scene::PunctualLight>(light);
    const auto center = view.project(glm::dvec3(punctual.position));
    if (!center) return;
    if (mark != LightMark::plain && kind == LightKind::spot) {
        drawCone(list, view, punctual, faded(color, 0.7), scale);
    } else if (kind != LightKind::point) {
        drawDirection(list, view, boxOf(light), faded(color, 0.8), scale);
    }
    drawPunctualMark(list, *center, hueOf(light), color, scale);
}

std::optional<LightBox> LightGizmo::update(ImDrawList& list, const ViewTransform& view,
                                           LightKind kind, const LightBox& box) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 mouse(io.MousePos.x, io.MousePos.y);
    Gizmo gizmo{mode, kind, box, usesWorldAxes ? glm::dmat3(1.0) : box.axes, interfaceScale()};
    std::optional<LightBox> result;
    if (drag_ && !io.MouseDown[0]) drag_.reset();
    if (drag_) {
        const DragOptions options{io.KeyCtrl, io.KeyShift, io.KeyAlt};
        result = dragged(*drag_, view, mouse, options);
        gizmo.box = *result;
        if (!usesWorldAxes) gizmo.axes = result->axes;
    }
    const std::vector<HandleShape> shapes = handleShapes(gizmo, view);
    if (!drag_) logHandles(gizmo, shapes);
    GizmoHandle hot = drag_ ? drag_->handle : GizmoHandle{};
    if (!drag_ && !io.WantCaptureMouse && view.contains(mouse)) hot = handleAt(shapes, mouse);
    isHovered_ = hot.kind != Kind::none;
    // With Alt the mouse is the camera's.
    if (isHovered_ && !drag_ && io.MouseClicked[0] && !io.KeyAlt) {
        drag_ = GizmoDrag{gizmo, hot, mouse};
    }
    // Those that are on top last.
    for (auto shape = shapes.rbegin(); shape != shapes.rend(); ++shape) {
        drawHandle(list, *shape, shape->handle == hot, gizmo.scale);
    }
    return result;
}

void LightGizmo::logHandles(const Gizmo& gizmo, const std::vector<HandleShape>& shapes) {
    const bool isKnown = logged_ && logged_->mode == gizmo.mode && logged_->kind == gizmo.kind &&
                         logged_->box.center == gizmo.box.center &&
                         logged_->box.half == gizmo.box.half && logged_->box.axes == gizmo.box.axes;
    if (isKnown) return;
    logged_ = gizmo;
    constexpr const char* kNames[] = {"none", "move", "plane", "free", "turn", "resize", "corner"};
    std::string text = "handles:";
    for (const HandleShape& shape : shapes) {
        // On a ring somewhere, else in the middle.
        const std::size_t count = shape.line.size();
        const glm::dvec2 at = shape.handle.kind == Kind::turn
                                  ? shape.line[count / 4]
                                  : 0.5 * (shape.line[0] + shape.line[count / 2]);
        text +=
            concat(" ", kNames[static_cast<int>(shape.handle.kind)], " ", "xyz"[shape.handle.axis],
                   shape.handle.side > 0 ? "+" : "-", shape.handle.otherSide > 0 ? "+" : "-", " (",
                   std::lround(at.x), ", ", std::lround(at.y), ")");
    }
    log(LogLevel::debug, text);
}

void LightGizmo::clear() {
    drag_.reset();
    logged_.reset();
    isHovered_ = false;
}

std::optional<LightBox> LightGizmo::cancel() {
    if (!drag_) return std::nullopt;
    const LightBox start = drag_->start.box;
    drag_.reset();
    return start;
}

}  // namespace polylume::viewer
