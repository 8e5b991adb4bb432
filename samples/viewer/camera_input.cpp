// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "camera_input.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

namespace polylume::viewer {
namespace {

/// A click may tremble by so much, in units of the window.
constexpr double kTremble = 4.0;
constexpr double kFastFlight = 4.0;

}  // namespace

bool CameraInput::flyByKeys(CameraControl& camera) const {
    const ImGuiIO& io = ImGui::GetIO();
    const auto axis = [&](int plus, int minus) {
        return static_cast<double>(io.KeysDown[plus]) - static_cast<double>(io.KeysDown[minus]);
    };
    glm::dvec3 direction(axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_E, GLFW_KEY_Q),
                         axis(GLFW_KEY_W, GLFW_KEY_S));
    if (direction == glm::dvec3(0.0)) return false;
    direction = glm::normalize(direction) * (io.KeyShift ? kFastFlight : 1.0);
    // A frame that took long is no leap.
    camera.fly(direction, std::min(static_cast<double>(io.DeltaTime), 0.1));
    return true;
}

bool CameraInput::update(CameraControl& camera, const ViewTransform& view, bool blocked) {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 mouse(io.MousePos.x, io.MousePos.y);
    const bool isFree = !blocked && !io.WantCaptureMouse && view.contains(mouse);
    wasClicked_ = false;
    bool moved = false;
    if (drag_ == Drag::none && isFree) {
        for (const int button : {0, 1, 2}) {
            if (!ImGui::IsMouseClicked(button)) continue;
            const bool pans = button == 2 || (button == 0 && io.KeyShift);
            drag_ = button == 1 ? Drag::fly : pans ? Drag::pan : Drag::orbit;
            button_ = button;
            hasMoved_ = false;
            start_ = last_ = mouse;
        }
    }
    if (drag_ != Drag::none) {
        if (glm::length(mouse - start_) > kTremble) hasMoved_ = true;
        const glm::dvec2 step = hasMoved_ ? (mouse - last_) / view.size.y : glm::dvec2(0.0);
        if (hasMoved_) last_ = mouse;
        if (step != glm::dvec2(0.0)) {
            moved = true;
            if (drag_ == Drag::orbit) camera.orbit(step);
            if (drag_ == Drag::pan) camera.pan(step);
            if (drag_ == Drag::fly) camera.look(step);
        }
        if (drag_ == Drag::fly && flyByKeys(camera)) moved = true;
        if (!io.MouseDown[button_]) {
            wasClicked_ = button_ == 0 && !hasMoved_;
            drag_ = Drag::none;
        }
    }
    if (io.MouseWheel != 0.0f && (isFree || isFlying())) {
        if (isFlying()) {
            camera.changeSpeed(io.MouseWheel);
        } else {
            camera.dolly(io.MouseWheel);
            moved = true;
        }
    }
    return moved;
}

}  // namespace polylume::viewer
