// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "window.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <array>
#include <string_view>
#include <utility>

#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::viewer {
namespace {

/// GLFW reports by a callback of its own; what it said last is the reason of a failure.
std::string lastGlfwError;

void keepError(int code, const char* text) {
    lastGlfwError = concat(text, " (GLFW error 0x", std::hex, code, ")");
    log(LogLevel::debug, lastGlfwError);
}

std::string stringOf(const gl::Functions& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

bool isSoftwareRenderer(std::string_view renderer) {
    constexpr std::array<std::string_view, 4> kNames = {"llvmpipe", "softpipe", "swrast", "SWR"};
    for (const std::string_view name : kNames) {
        if (renderer.find(name) != std::string_view::npos) return true;
    }
    return false;
}

Window& windowOf(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

}  // namespace

struct Window::Callbacks {
    static void add(GLFWwindow* handle, Event event) {
        Window& window = windowOf(handle);
        window.hasActivity_ = true;
        window.events_.push_back(event);
    }
    static void key(GLFWwindow* handle, int key, int scancode, int action, int modifiers) {
        add(handle, KeyEvent{key, scancode, action, modifiers});
    }
    static void button(GLFWwindow* handle, int button, int action, int modifiers) {
        add(handle, ButtonEvent{button, action == GLFW_PRESS, modifiers});
    }
    static void motion(GLFWwindow* handle, double x, double y) { add(handle, MotionEvent{{x, y}}); }
    static void wheel(GLFWwindow* handle, double x, double y) { add(handle, WheelEvent{{x, y}}); }
    static void character(GLFWwindow* handle, unsigned codepoint) {
        add(handle, CharacterEvent{codepoint});
    }
    static void drop(GLFWwindow* handle, int count, const char** paths) {
        Window& window = windowOf(handle);
        window.hasActivity_ = true;
        for (int i = 0; i < count; ++i) window.dropped_.emplace_back(paths[i]);
    }
    static void refresh(GLFWwindow* handle) { windowOf(handle).hasActivity_ = true; }
    static void resize(GLFWwindow* handle, int, int) { windowOf(handle).hasActivity_ = true; }
    static void rescale(GLFWwindow* handle, float, float) { windowOf(handle).hasActivity_ = true; }
};

Window::Window(glm::ivec2 size, const char* title) {
    glfwSetErrorCallback(keepError);
    if (glfwInit() != GLFW_TRUE) {
        throw ContextError(concat("no display: ", lastGlfwError,
                                  "; run it in a desktop session, or set DISPLAY (X11) or "
                                  "WAYLAND_DISPLAY to one; `polylume render` needs none"));
    }
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    handle_ = glfwCreateWindow(size.x, size.y, title, nullptr, nullptr);
    if (handle_ == nullptr) {
        const std::string reason = lastGlfwError;
        glfwTerminate();
        throw ContextError(concat("no window with OpenGL 4.5 core: ", reason,
                                  "; `polylume info` says what OpenGL is there, and Mesa's "
                                  "llvmpipe works without a graphics card"));
    }
    glfwMakeContextCurrent(handle_);
    const int version = gladLoadGLContext(&functions_, glfwGetProcAddress);
    if (version < GLAD_MAKE_VERSION(4, 5)) {
        glfwDestroyWindow(handle_);
        glfwTerminate();
        throw ContextError(
            "expected OpenGL 4.5 in the window, found less; `polylume info` says "
            "what OpenGL is there");
    }
    glfwSwapInterval(1);
    renderer_ = stringOf(functions_, GL_RENDERER);
    version_ = stringOf(functions_, GL_VERSION);
    software_ = isSoftwareRenderer(renderer_);
    debugLog_ = std::make_unique<gl::DebugLog>(functions_);
    glfwSetWindowUserPointer(handle_, this);
    glfwSetKeyCallback(handle_, Callbacks::key);
    glfwSetMouseButtonCallback(handle_, Callbacks::button);
    glfwSetCursorPosCallback(handle_, Callbacks::motion);
    glfwSetScrollCallback(handle_, Callbacks::wheel);
    glfwSetCharCallback(handle_, Callbacks::character);
    glfwSetDropCallback(handle_, Callbacks::drop);
    glfwSetWindowRefreshCallback(handle_, Callbacks::refresh);
    glfwSetFramebufferSizeCallback(handle_, Callbacks::resize);
    glfwSetWindowContentScaleCallback(handle_, Callbacks::rescale);
}

Window::~Window() {
    debugLog_.reset();
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::waitEvents(double seconds) {
    if (seconds > 0.0) {
        glfwWaitEventsTimeout(seconds);
    } else {
        glfwPollEvents();
    }
}

void Window::wake() {
    glfwPostEmptyEvent();
}

std::vector<std::filesystem::path> Window::takeDropped() {
    return std::exchange(dropped_, {});
}

bool Window::takeActivity() {
    return std::exchange(hasActivity_, false);
}

void Window::swapBuffers() {
    glfwSwapBuffers(handle_);
}

bool Window::shouldClose() const {
    return glfwWindowShouldClose(handle_) == GLFW_TRUE;
}

void Window::close() {
    glfwSetWindowShouldClose(handle_, GLFW_TRUE);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(handle_, title.c_str());
}

glm::ivec2 Window::size() const {
    glm::ivec2 size(0);
    glfwGetWindowSize(handle_, &size.x, &size.y);
    return size;
}

glm::ivec2 Window::framebufferSize() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(handle_, &size.x, &size.y);
    return size;
}

float Window::contentScale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(handle_, &x, &y);
    return y;
}

}  // namespace polylume::viewer
