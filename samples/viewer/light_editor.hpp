// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "scene/scene.hpp"
#include "view_transform.hpp"

namespace polylume::viewer {

/// Which light of a scene.
struct LightId {
    enum class Kind { area, punctual };
    Kind kind = Kind::area;
    int index = 0;  ///< Into Scene::areaLights or Scene::punctualLights.

    bool operator==(const LightId&) const = default;
};

/// Edits the lights of a scene: a list and fields in a panel, picking with the mouse, handles over
/// the picture, keys, undo. Draws with Dear ImGui, and knows no window system.
///
/// Call it between ImGui::NewFrame() and ImGui::Render(), in this order: handleKeys(), drawPanel()
/// within a window of the host's, drawGizmo(). Each returns whether lights of the scene changed, so
/// that the host sends them on and draws anew. The scene stays the host's; it may be another object
/// at each call, as long as its lights are what the last call left or reset() was called.
class LightEditor {
  public:
    LightEditor();
    ~LightEditor();
    LightEditor(LightEditor&&) noexcept;
    LightEditor& operator=(LightEditor&&) noexcept;

    /// Forgets the selection and all that could be undone: another scene is shown, or its lights
    /// were read again. With `keepSelection` the same light stays selected where there is one.
    void reset(bool keepSelection = false);

    /// Where images and bounds are taken from: those that can be laid on lights, and that new
    /// lights are placed by. The meshes' scene where lights are edited in another one; null: the
    /// edited scene itself.
    void setSurfaces(std::shared_ptr<const scene::Scene> surfaces);

    /// Acts on keys unless ImGui wants the text. Keys (io.KeysDown is indexed by GLFW's codes):
    /// 1 move, 2 turn, 3 resize, 4 no handles, X local or world axes, Delete deletes, Ctrl+D
    /// duplicates, Ctrl+Z undoes, Ctrl+Shift+Z or Ctrl+Y redoes, Escape deselects or cancels a drag
    /// of the handles.
    bool handleKeys(scene::Scene& scene);

    /// The list of all lights and the fields of the one selected, into the current ImGui window.
    bool drawPanel(scene::Scene& scene);

    /// The outline of the selected light and its handles, over the picture; follows drags of them.
    /// Draws to ImGui's background list, clipped to the picture, so that panels stay before it.
    bool drawGizmo(scene::Scene& scene, const ViewTransform& view);

    /// Selects the light under the mouse, or none. A light behind surfaces is found, too: it is
    /// seen through them. For a click on the picture that is not a drag and not wantsMouse().
    /// Returns whether the selection changed.
    bool pick(const scene::Scene& scene, const ViewTransform& view, const glm::dvec2& mouse);

    /// Whether the mouse is on a handle or drags one: the camera is to stay. Valid after
    /// drawGizmo() until the next one.
    bool wantsMouse() const;

    /// Whether a drag, of a handle or a field, is under way: the picture may be coarse till it
    /// ends.
    bool isDragging() const;

    std::optional<LightId> selected() const;
    void select(std::optional<LightId> light);

    /// The box around the selected light, to focus on; none without one.
    std::optional<scene::Bounds> selectedBounds(const scene::Scene& scene) const;

    /// Whether lights differ from what they were at reset() or markSaved().
    bool hasUnsavedChanges() const;
    void markSaved();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace polylume::viewer
