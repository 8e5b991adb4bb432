// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "light_editor_shapes.hpp"
#include "view_transform.hpp"

// Handles over a light: where they are, which one is under the mouse, what dragging one does.
namespace polylume::viewer {

enum class GizmoMode { none, move, turn, resize };

/// One handle. Along an axis: the axis. Across one, as the square between two axes or the ring
/// around it: the axis that it is across. `side` tells the two ends of an axis apart.
struct GizmoHandle {
    enum class Kind { none, moveAxis, movePlane, moveScreen, turn, resize, resizeCorner };
    Kind kind = Kind::none;
    int axis = 0;       ///< 0 to 2.
    int side = 1;       ///< Resize: +1 or -1 along the axis; of a corner, along X.
    int otherSide = 1;  ///< Of a corner, along Y.

    bool operator==(const GizmoHandle&) const = default;
};

/// What a gizmo is laid over.
struct Gizmo {
    GizmoMode mode = GizmoMode::move;
    LightKind kind = LightKind::rectangle;
    LightBox box;
    /// The axes of moving and turning: the box's or the world's. Resizing goes along the box's.
    glm::dmat3 axes{1.0};
    double scale = 1.0;  ///< Units of the mouse per pixel of a plain display.
};

/// A handle as it is drawn: lines on the window, and where its end is.
struct HandleShape {
    GizmoHandle handle;
    std::vector<glm::dvec2> line;  ///< An axis' two ends, a square's corners, the points of a ring.
    bool isArea = false;           ///< The line goes around what is hit; or is hit itself.
    double reach = 0.0;            ///< How near the mouse has to be to the line.
};

/// Metres in the world that one unit of the mouse is at a position's depth; 0 behind the camera.
double worldPerUnit(const ViewTransform& view, const glm::dvec3& positionWorld);

/// All handles that can be seen and dragged in this view, of the same size wherever the light is.
/// Axes that point at the viewer and squares seen from the edge are left out.
std::vector<HandleShape> handleShapes(const Gizmo& gizmo, const ViewTransform& view);

/// The handle under the mouse.
GizmoHandle handleAt(const std::vector<HandleShape>& shapes, const glm::dvec2& mouse);

/// How a drag is rounded.
struct DragOptions {
    bool snap = false;        ///< To a tenth of a metre or to 15 degrees, from where it began.
    bool keepShape = false;   ///< Resizing: all extents by the same factor.
    bool fromCenter = false;  ///< Resizing: the centre stays, else the other side.
};

/// A drag from where the mouse went down.
struct GizmoDrag {
    Gizmo start;
    GizmoHandle handle;
    glm::dvec2 mouse{0.0};
};

/// The box that the mouse has dragged the light's to; the start's where the view allows no answer,
/// as when a plane is seen from its edge.
LightBox dragged(const GizmoDrag& drag, const ViewTransform& view, const glm::dvec2& mouse,
                 const DragOptions& options);

/// Axes as three turns in degrees that a panel shows: around Z first, then X, then Y.
glm::dvec3 turnOf(const glm::dmat3& axes);
glm::dmat3 axesOf(const glm::dvec3& turnDegrees);

}  // namespace polylume::viewer
