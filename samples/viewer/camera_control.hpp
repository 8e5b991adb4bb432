// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "scene/scene.hpp"

namespace polylume::viewer {

/// Where a camera is and looks, in terms that a hand moves. Angles in radians.
struct CameraPose {
    glm::dvec3 pivot{0.0};  ///< What it turns around.
    double distance = 1.0;  ///< From the pivot, metres.
    double yaw = 0.0;    ///< Around +Y, of where the camera is from the pivot: 0 at +Z, pi/2 at +X.
    double pitch = 0.0;  ///< Above the horizon, -pi/2 to pi/2.
    double roll = 0.0;   ///< Around the optical axis.
    double zoom = 1.0;   ///< Of an orthographic camera: what its extents are divided by.

    glm::dmat3 axes() const;  ///< Columns: right, up, back.
    glm::dvec3 eye() const { return pivot + distance * axes()[2]; }
};

/// Moves a camera by mouse and keys, smoothly: what is asked for is a goal, which the camera nears
/// in a tenth of a second. The horizon stays level, and nothing flips over at the poles.
class CameraControl {
  public:
    /// Shows what `camera` shows, to the last bit until it is moved. `bounds` are the scene's, for
    /// speeds and distances.
    void reset(const scene::Camera& camera, const scene::Bounds& bounds);
    /// The same, as a movement from where it is now.
    void moveTo(const scene::Camera& camera);
    /// Takes over a scene that was read again, and stays.
    void setBounds(const scene::Bounds& bounds) { bounds_ = bounds; }

    /// Turns around the pivot; a drag of the mouse in pixels over the height of the picture.
    void orbit(const glm::dvec2& drag);
    /// Moves across the view, so that what lies at the pivot follows the mouse.
    void pan(const glm::dvec2& drag);
    /// Nears the pivot by so many steps of a wheel; negative: away.
    void dolly(double steps);
    /// Turns around the camera itself, as a drag asks.
    void look(const glm::dvec2& drag);
    /// Flies: metres right, up and ahead for speeds of 1, over `seconds`.
    void fly(const glm::dvec3& direction, double seconds);
    /// Steps of the wheel while flying.
    void changeSpeed(double steps);
    /// Looks at all of `bounds` from the present side.
    void focus(const scene::Bounds& bounds);

    /// Goes on for `seconds`. Returns whether the view changed.
    bool update(double seconds);
    /// Whether it is on its way.
    bool isMoving() const { return !isAtGoal_; }

    /// The camera as it is now.
    scene::Camera camera() const;
    const CameraPose& pose() const { return pose_; }
    double speed() const { return speed_; }  ///< Metres a second.
    /// Whether it shows what the camera of the last reset() or moveTo() does.
    bool isExact() const { return exact_.has_value() && isAtGoal_; }

  private:
    CameraPose poseOf(const scene::Camera& camera) const;
    void changed();
    double halfHeight() const;  ///< Of what is seen at the pivot, metres.

    scene::Camera lens_;  ///< Projection and name.
    scene::Bounds bounds_;
    CameraPose pose_, goal_;
    std::optional<glm::mat4> exact_;  ///< Of the goal, while nobody has moved it.
    bool isAtGoal_ = true;
    double speed_ = 1.0;
};

}  // namespace polylume::viewer
