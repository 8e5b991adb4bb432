// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <deque>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "gl/debug_log.hpp"
#include "gl/functions.hpp"

struct GLFWwindow;

namespace polylume::viewer {

/// What the hands do. Keys, buttons and modifiers are numbered as GLFW does it.
struct KeyEvent {
    int key = 0;
    int scancode = 0;
    int action = 0;
    int modifiers = 0;
};
struct ButtonEvent {
    int button = 0;
    bool isDown = false;
    int modifiers = 0;
};
struct MotionEvent {
    glm::dvec2 position{0.0};  ///< From the window's upper left corner, in window coordinates.
};
struct WheelEvent {
    glm::dvec2 steps{0.0};
};
struct CharacterEvent {
    unsigned codepoint = 0;
};
using Event = std::variant<KeyEvent, ButtonEvent, MotionEvent, WheelEvent, CharacterEvent>;

/// A window with an OpenGL 4.5 core context that is current, by GLFW. There is one at a time.
class Window {
  public:
    /// Throws ContextError where there is no display or no such context.
    Window(glm::ivec2 size, const char* title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Takes in events; waits up to `seconds` for the first one.
    void waitEvents(double seconds);
    /// Ends a wait of the window's thread. From any thread.
    static void wake();
    /// What came in since, oldest first; the owner takes from the front.
    std::deque<Event>& events() { return events_; }
    /// Files that were dropped since the last call.
    std::vector<std::filesystem::path> takeDropped();
    /// Whether anything came in by the last waitEvents(), also what is no event: a new size, say.
    bool takeActivity();

    void swapBuffers();
    bool shouldClose() const;
    void close();
    void setTitle(const std::string& title);

    glm::ivec2 size() const;             ///< In window coordinates.
    glm::ivec2 framebufferSize() const;  ///< Pixels; 0 while it is an icon.
    float contentScale() const;          ///< 1 for 96 dots an inch.
    bool isSoftware() const { return software_; }
    const std::string& renderer() const { return renderer_; }
    const std::string& version() const { return version_; }

    GLFWwindow* handle() const { return handle_; }
    const gl::Functions& functions() const { return functions_; }
    gl::DebugLog& debugLog() { return *debugLog_; }

  private:
    struct Callbacks;

    GLFWwindow* handle_ = nullptr;
    gl::Functions functions_{};
    std::unique_ptr<gl::DebugLog> debugLog_;
    std::deque<Event> events_;
    std::vector<std::filesystem::path> dropped_;
    bool hasActivity_ = true;
    bool software_ = false;
    std::string renderer_, version_;
};

}  // namespace polylume::viewer
