// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "light_editor.hpp"
#include "light_editor_shapes.hpp"
#include "light_gizmo.hpp"

namespace polylume::viewer {

/// What is asked for in the panel beyond changing the selected light.
struct PanelRequest {
    std::optional<LightKind> add;
    std::optional<LightId> select;
    bool duplicate = false;
    bool remove = false;
    bool undo = false;
    bool redo = false;
};

/// The list of lights and the fields of the selected one.
class LightPanel {
  public:
    /// The buttons above the list, and the list.
    PanelRequest drawList(const scene::Scene& scene, std::optional<LightId> selected, bool canUndo,
                          bool canRedo);

    /// The modes of the handles.
    void drawModes(LightGizmo& gizmo);

    /// The fields of one light; the changed light where one changed. `hint` as boxOf() has it.
    /// `pictures` has images, and lights whose pictures can be shown by this light, too.
    std::optional<AnyLight> drawFields(const AnyLight& light, const glm::dmat3& hint,
                                       const scene::Scene& images, const scene::Scene& lights);

    /// Another light is selected.
    void reset();

  private:
    bool drawPlace(AnyLight& light, const glm::dmat3& hint);
    bool drawSize(AnyLight& light, const glm::dmat3& hint);
    bool drawEmission(AnyLight& light);
    bool drawSides(AnyLight& light);
    bool drawPicture(AnyLight& light, const glm::dmat3& hint, const scene::Scene& images,
                     const scene::Scene& lights);
    bool drawPunctual(scene::PunctualLight& light);

    std::optional<glm::dvec3> turnDegrees_;  ///< While it is being edited.
    std::optional<glm::vec3> color_;         ///< sRGB, of a light that is dark or being coloured.
    std::string pictureFile_;
    std::string pictureError_;
};

}  // namespace polylume::viewer
