// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "window.hpp"

struct GLFWcursor;

namespace polylume::viewer {

/// Dear ImGui on a Window: its context, looks and fonts for any content scale, and the window's
/// events, in which no quick press is lost however long a frame takes.
class ImGuiLayer {
  public:
    /// Its context is current from here on.
    explicit ImGuiLayer(Window& window);
    ~ImGuiLayer();
    ImGuiLayer(const ImGuiLayer&) = delete;
    ImGuiLayer& operator=(const ImGuiLayer&) = delete;

    /// Hands over events up to one that needs a frame of its own, and begins a frame.
    void beginFrame();
    /// Whether events are left for the next frame.
    bool hasMoreEvents() const { return !window_.events().empty(); }
    /// The presses (also repeated ones) of keys in this frame.
    const std::vector<KeyEvent>& pressedKeys() const { return pressedKeys_; }
    /// Draws the interface into the bound framebuffer.
    void endFrame();

    /// What a length of Dear ImGui's style at 96 dots an inch is multiplied with.
    float scale() const { return scale_; }
    /// Framebuffer pixels in a unit of the window.
    float pixelRatio() const { return pixelRatio_; }

  private:
    void updateScale();
    void buildFonts(float pixels);
    void takeEvents();
    void showCursor();

    Window& window_;
    float scale_ = 0.0f;
    float pixelRatio_ = 1.0f;
    std::vector<KeyEvent> pressedKeys_;
    glm::dvec2 mouse_{-1e9};
    bool buttons_[5] = {};
    bool hasPointer_ = false;  ///< It has moved, so there is one.
    double lastFrame_ = 0.0;   ///< Seconds of GLFW's clock.
    std::map<int, GLFWcursor*> cursors_;
    int shownCursor_ = 0;
};

}  // namespace polylume::viewer
