// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <optional>

#include "light_gizmo_math.hpp"

struct ImDrawList;

namespace polylume::viewer {

/// The handles over the selected light, drawn and dragged with Dear ImGui.
class LightGizmo {
  public:
    GizmoMode mode = GizmoMode::move;
    bool usesWorldAxes = false;

    /// Draws the handles and follows the mouse: Ctrl snaps, Shift keeps the shape, Alt the centre.
    /// What the light's box is to become while a handle is dragged.
    std::optional<LightBox> update(ImDrawList& list, const ViewTransform& view, LightKind kind,
                                   const LightBox& box);

    /// No light is selected: nothing is under the mouse.
    void clear();
    /// Ends a drag; the box that it began with, where there was one.
    std::optional<LightBox> cancel();

    bool isDragging() const { return drag_.has_value(); }
    bool wantsMouse() const { return isDragging() || isHovered_; }

  private:
    /// Says in the log where the handles are, for who drives the window by a script.
    void logHandles(const Gizmo& gizmo, const std::vector<HandleShape>& shapes);

    std::optional<GizmoDrag> drag_;
    bool isHovered_ = false;
    std::optional<Gizmo> logged_;
};

/// Pixels of a plain display as units of the mouse, by the size of ImGui's font.
double interfaceScale();

/// How a light that can't be seen, or is to be found, is marked on the picture.
enum class LightMark { plain, hovered, selected };
void drawLightMark(ImDrawList& list, const ViewTransform& view, const AnyLight& light,
                   LightMark mark);

}  // namespace polylume::viewer
