// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "camera_control.hpp"
#include "view_transform.hpp"

namespace polylume::viewer {

/// Moves a camera by the mouse on the picture and by the keys of flight, as Dear ImGui has them in
/// a frame: left drag turns, middle or Shift drag moves across, the wheel goes nearer; with the
/// right button held the mouse looks around and W, A, S, D, Q and E fly.
class CameraInput {
  public:
    /// `blocked`: something else has the mouse, so no drag begins. Returns whether the camera was
    /// asked to move.
    bool update(CameraControl& camera, const ViewTransform& view, bool blocked);

    /// Whether keys are those of flight now.
    bool isFlying() const { return drag_ == Drag::fly; }
    bool isDragging() const { return drag_ != Drag::none; }
    /// Whether the left button was pressed and let go on the picture without a drag, in this frame.
    bool wasClicked() const { return wasClicked_; }

  private:
    enum class Drag { none, orbit, pan, fly };
    bool flyByKeys(CameraControl& camera) const;

    Drag drag_ = Drag::none;
    int button_ = 0;  ///< That drags.
    bool hasMoved_ = false;
    bool wasClicked_ = false;
    glm::dvec2 last_{0.0};
    glm::dvec2 start_{0.0};
};

}  // namespace polylume::viewer
