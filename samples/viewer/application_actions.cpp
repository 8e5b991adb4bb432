// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

#include "application.hpp"
#include "core/log.hpp"
#include "help_panel.hpp"
#include "picture_saver.hpp"
#include "scene/scene_writer.hpp"
#include "settings_panel.hpp"
#include "stats_panel.hpp"

namespace polylume::viewer {

namespace fs = std::filesystem;

void Application::handleKey(const KeyEvent& key) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    const char* const name = glfwGetKeyName(key.key, key.scancode);
    keysShown_ += fmt::format(" {}", name != nullptr ? name : std::to_string(key.key));
    if (key.key == GLFW_KEY_F12 && key.action == GLFW_PRESS) {
        const bool asExr = (key.modifiers & GLFW_MOD_SHIFT) != 0;
        return attempt([&] { takeScreenshot(asExr); });
    }
    if ((key.modifiers & GLFW_MOD_CONTROL) != 0) {
        if (key.key == GLFW_KEY_S && key.action == GLFW_PRESS) attempt([&] { saveScene(); });
        return;
    }
    // While it flies, letters steer.
    if (!cameraInput_.isFlying()) handlePlainKey(key.key);
}

void Application::handlePlainKey(int key) {
    constexpr double kExposureStep = 1.0 / 3.0;
    switch (key) {
        case GLFW_KEY_F1:
            showsHelp_ = !showsHelp_;
            break;
        case GLFW_KEY_F5:
            reloadAll();
            break;
        case GLFW_KEY_TAB:
            showsPanel_ = !showsPanel_;
            break;
        case GLFW_KEY_ESCAPE:
            showsHelp_ = false;
            messages_.clearError();
            break;
        case GLFW_KEY_R:
            split_->toggleReference();
            break;
        case GLFW_KEY_E:
            split_->toggleError();
            break;
        case GLFW_KEY_F:
            focus();
            break;
        case GLFW_KEY_HOME:
            showCamera(cameraIndex_);
            break;
        case GLFW_KEY_C:
            showCamera(cameraIndex_ + 1);
            break;
        case GLFW_KEY_LEFT_BRACKET:
            settings_.exposure = renderer_->ev() + kExposureStep;
            break;
        case GLFW_KEY_RIGHT_BRACKET:
            settings_.exposure = renderer_->ev() - kExposureStep;
            break;
        case GLFW_KEY_A:
            settings_.exposure.reset();
            break;
        case GLFW_KEY_T:
            settings_.toneMap = nextToneMap(settings_.toneMap);
            break;
        case GLFW_KEY_Q:
            settings_.model.quality =
                settings_.model.quality == Quality::high ? Quality::standard : Quality::high;
            break;
        case GLFW_KEY_L:
            settings_.lobes = nextLobes(settings_.lobes);
            break;
        case GLFW_KEY_H:
            settings_.hideLights = !settings_.hideLights;
            break;
        default:
            break;
    }
}

void Application::handleControls() {
    const double now = seconds();
    const float scale = imgui_->scale();
    ViewTransform view = viewTransform();
    bool haveLightsChanged = false;
    if (document_ && !ImGui::GetIO().WantTextInput && !cameraInput_.isFlying()) {
        haveLightsChanged = editor_.handleKeys(document_->lights);
    }
    if (showsPanel_) drawPanel();
    if (document_) {
        if (showsPanel_) haveLightsChanged |= panelChangedLights_;
        panelChangedLights_ = false;
        haveLightsChanged |= editor_.drawGizmo(document_->lights, view);
        const bool alt = ImGui::GetIO().KeyAlt;
        const bool editorHasMouse = editor_.wantsMouse() && !alt;
        split_->handleMouse(view, editorHasMouse || cameraInput_.isDragging());
        split_->drawOverlay(view, scale);
        const bool isBlocked = editorHasMouse || split_->wantsMouse();
        cameraInput_.update(camera_, view, isBlocked);
        if (cameraInput_.wasClicked()) {
            const ImVec2 mouse = ImGui::GetIO().MousePos;
            editor_.pick(document_->lights, view, {mouse.x, mouse.y});
        }
        if (haveLightsChanged) lightsChanged();
        const bool changesMaterials = settings_.roughness != renderer_->settings().roughness ||
                                      settings_.metalness != renderer_->settings().metalness;
        if (changesMaterials) split_->stopReading();
        renderer_->setSettings(settings_);
    }
    if (loader_->isBusy()) {
        drawNotice(view, scale,
                   fmt::format("Reading {}", loader_->request().scene.filename().string()),
                   loader_->progress());
    } else if (!document_) {
        drawNotice(view, scale, "Drop a glTF scene here (.gltf or .glb)", -1.0);
    }
    messages_.draw(view, scale, now);
    drawHelp(showsHelp_, scale);
}

void Application::lightsChanged() {
    hasEditedLights_ = true;
    renderer_->updateLights();
}

void Application::drawPanel() {
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({static_cast<float>(pictureOrigin_.x), io.DisplaySize.y});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus;
    constexpr ImGuiWindowFlags kScrolls = kFlags & ~ImGuiWindowFlags_NoScrollbar;
    if (ImGui::Begin("panel", nullptr, kScrolls)) {
        ImGui::PushItemWidth(-100.0f * imgui_->scale());
        drawPanelSections();
        ImGui::PopItemWidth();
    }
    ImGui::End();
}

void Application::drawPanelSections() {
    const auto section = [](const char* name, bool isOpen) {
        return ImGui::CollapsingHeader(name, isOpen ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    };
    drawSceneSection();
    if (!document_) return;
    if (section("Lights", true)) {
        attempt([&] { panelChangedLights_ = editor_.drawPanel(document_->lights); });
    }
    if (section("Lighting", true)) drawLightingControls(settings_);
    if (section("Materials", true)) drawMaterialControls(settings_);
    if (section("Reference", true)) drawReferenceControls(*split_);
    if (section("Display", true)) drawDisplayControls(settings_, renderer_->ev());
    if (section("Statistics", true)) {
        drawStatistics(*renderer_, *document_, frameMilliseconds_,
                       fmt::format("{}, OpenGL {}", window_->renderer(), window_->version()));
    }
}

void Application::drawSceneSection() {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "Polylume");
    ImGui::SameLine();
    ImGui::TextDisabled("F1 lists the keys");
    if (!document_) {
        ImGui::TextWrapped("No scene yet.");
        return;
    }
    ImGui::TextWrapped("%s%s", document_->lights.name.c_str(),
                       editor_.hasUnsavedChanges() ? " (lights changed)" : "");
    const int picked = drawCameraControls(document_->lights, cameraIndex_);
    if (picked >= 0) showCamera(picked);
    if (ImGui::Button("Reset view")) showCamera(cameraIndex_);
    ImGui::SameLine();
    if (ImGui::Button("Save PNG")) attempt([&] { takeScreenshot(false); });
    ImGui::SameLine();
    if (ImGui::Button("Save EXR")) attempt([&] { takeScreenshot(true); });
    if (saveName_[0] == '\0') {
        std::snprintf(saveName_, sizeof(saveName_), "%s", saveTarget().filename().c_str());
    }
    ImGui::InputText("##save", saveName_, sizeof(saveName_), ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "What the scene is saved as, with its lights and this view:\n.gltf or .glb, from its "
            "own folder on");
    }
    ImGui::SameLine();
    if (ImGui::Button("Save scene")) attempt([&] { saveScene(); });
}

void Application::showCamera(int index) {
    if (!document_) return;
    cameraIndex_ = index % static_cast<int>(document_->lights.cameras.size());
    camera_.moveTo(document_->lights.cameras[static_cast<std::size_t>(cameraIndex_)]);
}

void Application::focus() {
    if (!document_) return;
    camera_.focus(editor_.selectedBounds(document_->lights).value_or(document_->bounds));
}

void Application::reloadAll() {
    if (document_) openScene(document_->request);
    try {
        renderer_->reloadShaders();
        messages_.clearError();
    } catch (const std::exception& error) {
        messages_.showError(error.what());
        forgetGlErrors();
    }
}

/// Whether `polylume render` of the scene's file gives another picture.
bool Application::differsFromFile() const {
    return hasEditedLights_ || !camera_.isExact() || settings_.roughness || settings_.metalness;
}

/// Whether that of the saved file gives this one.
bool Application::isAsSaved() const {
    return !savedAs_.empty() && !editor_.hasUnsavedChanges() &&
           savedCamera_.worldFromCamera == renderer_->camera().worldFromCamera &&
           savedSettings_.roughness == settings_.roughness &&
           savedSettings_.metalness == settings_.metalness;
}

std::string Application::renderHint(const fs::path& output) const {
    RenderCommandText text;
    text.output = output;
    text.size = renderer_->size();
    if (isAsSaved()) {
        text.scene = savedAs_;
        return commandLine(text, settings_);
    }
    if (differsFromFile()) return "Save the scene (Ctrl+S) to render the same picture";
    const SceneRequest& request = document_->request;
    text.scene = request.scene;
    text.lights = request.lights;
    text.emissiveLights = request.emissiveLights;
    if (cameraIndex_ != 0) text.camera = cameraIndex_;
    return commandLine(text, settings_);
}

void Application::attempt(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        messages_.showError(error.what());
    }
}

void Application::takeScreenshot(bool asExr) {
    if (!document_) return;
    const std::string stem = document_->request.scene.stem().string();
    const fs::path output = freeName(stem, asExr ? ".exr" : ".png");
    savePicture(output, *renderer_, *document_, window_->renderer());
    messages_.say(fmt::format("Wrote {}\n{}", output.string(), renderHint(output)));
}

fs::path Application::saveTarget() {
    if (!savedAs_.empty()) return savedAs_;
    const fs::path& source = document_->request.scene;
    for (int number = 1;; ++number) {
        const std::string suffix = number == 1 ? "_edited" : fmt::format("_edited{}", number);
        fs::path target =
            source.parent_path() / (source.stem().string() + suffix + source.extension().string());
        if (!fs::exists(target)) return target;
    }
}

void Application::saveScene() {
    if (!document_) return;
    const fs::path folder = document_->request.scene.parent_path();
    const fs::path target = saveName_[0] != '\0' ? folder / saveName_ : saveTarget();
    scene::SceneEdits edits;
    edits.areaLights = document_->lights.areaLights;
    edits.punctualLights = document_->lights.punctualLights;
    edits.camera = renderer_->camera();
    edits.roughness = settings_.roughness;
    edits.metalness = settings_.metalness;
    scene::writeEditedScene(document_->request.scene, edits, target);
    savedAs_ = target;
    savedCamera_ = renderer_->camera();
    savedSettings_ = settings_;
    editor_.markSaved();
    // What was written here is no news.
    sceneWatch_.watch(document_->files);
    messages_.say(fmt::format("Wrote {}\n{}", target.string(),
                              renderHint(fs::path(target).replace_extension(".png"))));
}

}  // namespace polylume::viewer
