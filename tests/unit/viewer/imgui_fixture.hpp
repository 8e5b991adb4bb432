// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <optional>

#include "light_editor.hpp"
#include "unit/viewer/light_views.hpp"

namespace polylume::viewer::test {

/// A light editor in Dear ImGui without a window: the test moves the mouse and presses keys, frame
/// by frame, as the program's window does.
class LightEditorFixture : public testing::Test {
  protected:
    static constexpr float kPanelWidth = 260.0f;
    // As GLFW has them.
    static constexpr int kDelete = 261;
    static constexpr int kEscape = 256;

    void SetUp() override {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1060.0f, 620.0f};
        io.DeltaTime = 1.0f / 60.0f;
        io.KeyMap[ImGuiKey_Delete] = kDelete;
        io.KeyMap[ImGuiKey_Escape] = kEscape;
        io.KeyMap[ImGuiKey_Enter] = 257;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        io.MousePos = {-1.0f, -1.0f};
        scene_.areaLights.push_back(rectangleLight());
        scene_.areaLights.push_back({"ball", SphereLight{{-1.2f, 0.6f, 0.0f}, 0.3f}, ""});
        scene_.punctualLights.push_back({"bulb"});
        scene_.punctualLights[0].position = {1.6f, 0.3f, 0.0f};
        frame();
    }

    void TearDown() override { ImGui::DestroyContext(); }

    /// One frame, as the program has it; whether lights changed.
    bool frame() {
        ImGui::NewFrame();
        bool hasChanged = editor_.handleKeys(scene_);
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({kPanelWidth, 620.0f});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
        hasChanged |= editor_.drawPanel(scene_);
        ImGui::End();
        hasChanged |= editor_.drawGizmo(scene_, view_);
        ImGui::Render();
        return hasChanged;
    }

    bool moveMouse(const glm::dvec2& to) {
        ImGui::GetIO().MousePos = {static_cast<float>(to.x), static_cast<float>(to.y)};
        return frame();
    }

    bool pressMouse(bool isDown) {
        ImGui::GetIO().MouseDown[0] = isDown;
        return frame();
    }

    /// Drags from one place to another; whether lights changed.
    bool drag(const glm::dvec2& from, const glm::dvec2& to) {
        moveMouse(from);
        bool hasChanged = pressMouse(true);
        for (int i = 1; i <= 4; ++i) hasChanged |= moveMouse(glm::mix(from, to, i / 4.0));
        return pressMouse(false) || hasChanged;
    }

    /// Presses and lets go; whether lights changed.
    bool press(int key, bool ctrl = false, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = ctrl;
        io.KeyShift = shift;
        io.KeysDown[key] = true;
        bool hasChanged = frame();
        io.KeysDown[key] = false;
        io.KeyCtrl = io.KeyShift = false;
        return frame() || hasChanged;
    }

    /// Clicks on the picture, as the program does.
    void click(const glm::dvec2& at) {
        moveMouse(at);
        ASSERT_FALSE(editor_.wantsMouse());
        editor_.pick(scene_, view_, at);
        frame();
    }

    glm::dvec2 pixelOf(const glm::dvec3& position) const { return *view_.project(position); }

    scene::Scene scene_;
    LightEditor editor_;
    ViewTransform view_ = perspectiveView();
};

}  // namespace polylume::viewer::test
