// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "imgui_layer.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <utility>

namespace polylume::viewer {
namespace {

constexpr float kFontSize = 15.0f;  // At 96 dots an inch.

/// Where distributions have a sans-serif font; without one Dear ImGui's own serves.
constexpr const char* kFonts[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                  "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                                  "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf"};

ImVec4 grey(float value, float alpha = 1.0f) {
    return {value, value, value * 1.02f, alpha};
}

/// Quiet greys, so that the picture is what is looked at, and one warm accent.
void setLooks(ImGuiStyle& style) {
    const ImVec4 accent(0.93f, 0.66f, 0.29f, 1.0f);
    const auto faded = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
    ImVec4* colors = style.Colors;
    colors[ImGuiCol_Text] = grey(0.90f);
    colors[ImGuiCol_TextDisabled] = grey(0.55f);
    colors[ImGuiCol_WindowBg] = grey(0.115f);
    colors[ImGuiCol_ChildBg] = grey(0.10f);
    colors[ImGuiCol_PopupBg] = grey(0.14f, 0.97f);
    colors[ImGuiCol_Border] = grey(0.24f);
    colors[ImGuiCol_FrameBg] = grey(0.19f);
    colors[ImGuiCol_FrameBgHovered] = grey(0.25f);
    colors[ImGuiCol_FrameBgActive] = grey(0.29f);
    colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = grey(0.09f);
    colors[ImGuiCol_ScrollbarBg] = grey(0.10f);
    colors[ImGuiCol_ScrollbarGrab] = grey(0.28f);
    colors[ImGuiCol_ScrollbarGrabHovered] = grey(0.36f);
    colors[ImGuiCol_ScrollbarGrabActive] = grey(0.42f);
    colors[ImGuiCol_CheckMark] = faded(1.0f);
    colors[ImGuiCol_SliderGrab] = faded(0.6f);
    colors[ImGuiCol_SliderGrabActive] = faded(1.0f);
    colors[ImGuiCol_Button] = grey(0.22f);
    colors[ImGuiCol_ButtonHovered] = grey(0.30f);
    colors[ImGuiCol_ButtonActive] = faded(0.55f);
    colors[ImGuiCol_Header] = grey(0.175f);
    colors[ImGuiCol_HeaderHovered] = grey(0.24f);
    colors[ImGuiCol_HeaderActive] = faded(0.45f);
    colors[ImGuiCol_Separator] = grey(0.22f);
    colors[ImGuiCol_PlotHistogram] = faded(0.9f);
    colors[ImGuiCol_TextSelectedBg] = faded(0.35f);
    style.WindowRounding = 0.0f;
    style.FrameRounding = 4.0f;
    style.GrabRounding = 4.0f;
    style.PopupRounding = 6.0f;
    style.ScrollbarSize = 12.0f;
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {7.0f, 4.0f};
    style.ItemSpacing = {8.0f, 6.0f};
    style.WindowBorderSize = 0.0f;
}

/// Where Dear ImGui finds the keys of text fields in io.KeysDown.
void mapKeys(ImGuiIO& io) {
    constexpr std::pair<ImGuiKey_, int> kKeys[] = {
        {ImGuiKey_Tab, GLFW_KEY_TAB},
        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
        {ImGuiKey_UpArrow, GLFW_KEY_UP},
        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
        {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
        {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
        {ImGuiKey_Home, GLFW_KEY_HOME},
        {ImGuiKey_End, GLFW_KEY_END},
        {ImGuiKey_Insert, GLFW_KEY_INSERT},
        {ImGuiKey_Delete, GLFW_KEY_DELETE},
        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
        {ImGuiKey_Space, GLFW_KEY_SPACE},
        {ImGuiKey_Enter, GLFW_KEY_ENTER},
        {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
        {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
        {ImGuiKey_A, GLFW_KEY_A},
        {ImGuiKey_C, GLFW_KEY_C},
        {ImGuiKey_V, GLFW_KEY_V},
        {ImGuiKey_X, GLFW_KEY_X},
        {ImGuiKey_Y, GLFW_KEY_Y},
        {ImGuiKey_Z, GLFW_KEY_Z},
    };
    for (const auto& [name, key] : kKeys) io.KeyMap[name] = key;
}

void setKey(ImGuiIO& io, const KeyEvent& event) {
    if (event.key < 0 || event.key >= static_cast<int>(std::size(io.KeysDown))) return;
    io.KeysDown[event.key] = event.action != GLFW_RELEASE;
    // Not the event's modifiers, which X11 and Wayland give from before and from after the key.
    const auto isDown = [&io](int left, int right) {
        return io.KeysDown[left] || io.KeysDown[right];
    };
    io.KeyCtrl = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = isDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = isDown(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

const char* clipboardText(void* window) {
    return glfwGetClipboardString(static_cast<GLFWwindow*>(window));
}

void setClipboardText(void* window, const char* text) {
    glfwSetClipboardString(static_cast<GLFWwindow*>(window), text);
}

}  // namespace

ImGuiLayer::ImGuiLayer(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    // In place of Dear ImGui's own backend for GLFW, whose callbacks lose presses within a frame,
    // and which asks for cursors where there is no pointer: GLFW 3.3 crashes at that on Wayland.
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.GetClipboardTextFn = clipboardText;
    io.SetClipboardTextFn = setClipboardText;
    io.ClipboardUserData = window_.handle();
    mapKeys(io);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    updateScale();
}

ImGuiLayer::~ImGuiLayer() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
    for (auto& [shape, cursor] : cursors_) glfwDestroyCursor(cursor);
}

void ImGuiLayer::updateScale() {
    const glm::ivec2 size = window_.size();
    const glm::ivec2 pixels = window_.framebufferSize();
    if (size.x > 0 && pixels.x > 0) {
        pixelRatio_ = static_cast<float>(pixels.x) / static_cast<float>(size.x);
    }
    // Where the window's units are pixels (X11) the interface is enlarged here; where they are
    // larger (Wayland) the system does it, and only glyphs need the finer pixels.
    const float scale = std::max(window_.contentScale() / pixelRatio_, 0.5f);
    if (scale == scale_) return;
    scale_ = scale;
    ImGuiStyle style;
    ImGui::StyleColorsDark(&style);
    setLooks(style);
    style.ScaleAllSizes(scale_);
    ImGui::GetStyle() = style;
    buildFonts(kFontSize * scale_ * pixelRatio_);
    ImGui::GetIO().FontGlobalScale = 1.0f / pixelRatio_;
}

void ImGuiLayer::buildFonts(float pixels) {
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    ImFont* font = nullptr;
    for (const char* path : kFonts) {
        std::error_code error;
        if (!std::filesystem::exists(path, error)) continue;
        font = fonts.AddFontFromFileTTF(path, std::round(pixels));
        break;
    }
    if (font == nullptr) {
        ImFontConfig config;
        config.SizePixels = std::round(pixels);
        fonts.AddFontDefault(&config);
    }
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void ImGuiLayer::takeEvents() {
    pressedKeys_.clear();
    ImGuiIO& io = ImGui::GetIO();
    std::deque<Event>& events = window_.events();
    // A key or button that goes down and up would do so unseen within one frame, and a drag would
    // be seen at its end alone: what undoes or moves what came before waits for the next frame.
    std::set<int> keys;
    std::set<int> buttons;
    while (!events.empty()) {
        const Event& event = events.front();
        if (const auto* key = std::get_if<KeyEvent>(&event)) {
            if (key->action != GLFW_REPEAT && !keys.insert(key->key).second) return;
            setKey(io, *key);
            if (key->action != GLFW_RELEASE) pressedKeys_.push_back(*key);
        } else if (const auto* button = std::get_if<ButtonEvent>(&event)) {
            if (!buttons.insert(button->button).second) return;
            if (button->button >= 0 && button->button < 5) {
                buttons_[button->button] = button->isDown;
            }
        } else if (const auto* motion = std::get_if<MotionEvent>(&event)) {
            if (!buttons.empty()) return;
            mouse_ = motion->position;
            hasPointer_ = true;
        } else if (const auto* wheel = std::get_if<WheelEvent>(&event)) {
            io.MouseWheelH += static_cast<float>(wheel->steps.x);
            io.MouseWheel += static_cast<float>(wheel->steps.y);
        } else if (const auto* character = std::get_if<CharacterEvent>(&event)) {
            io.AddInputCharacter(character->codepoint);
        }
        events.pop_front();
    }
}

void ImGuiLayer::beginFrame() {
    updateScale();
    ImGui_ImplOpenGL3_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 size(window_.size());
    io.DisplaySize = {size.x, size.y};
    io.DisplayFramebufferScale = {pixelRatio_, pixelRatio_};
    const double now = glfwGetTime();
    io.DeltaTime = static_cast<float>(std::max(now - lastFrame_, 1e-4));
    lastFrame_ = now;
    takeEvents();
    io.MousePos = {static_cast<float>(mouse_.x), static_cast<float>(mouse_.y)};
    std::copy(std::begin(buttons_), std::end(buttons_), io.MouseDown);
    ImGui::NewFrame();
}

void ImGuiLayer::endFrame() {
    ImGui::Render();
    const glm::ivec2 pixels = window_.framebufferSize();
    window_.functions().Viewport(0, 0, pixels.x, pixels.y);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    showCursor();
}

void ImGuiLayer::showCursor() {
    if (!hasPointer_) return;
    int shape = GLFW_ARROW_CURSOR;
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            shape = GLFW_IBEAM_CURSOR;
            break;
        case ImGuiMouseCursor_ResizeEW:
            shape = GLFW_HRESIZE_CURSOR;
            break;
        case ImGuiMouseCursor_ResizeNS:
            shape = GLFW_VRESIZE_CURSOR;
            break;
        case ImGuiMouseCursor_Hand:
            shape = GLFW_HAND_CURSOR;
            break;
        default:
            break;
    }
    if (shape == shownCursor_) return;
    const auto [entry, isNew] = cursors_.try_emplace(shape, nullptr);
    if (isNew) entry->second = glfwCreateStandardCursor(shape);
    glfwSetCursor(window_.handle(), entry->second);
    shownCursor_ = shape;
}

}  // namespace polylume::viewer
