// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "settings_panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace polylume::viewer {
namespace {

/// A drop-down of a value that counts from 0.
template <typename Value, std::size_t count>
void choose(const char* label, Value& value, const char* const (&names)[count]) {
    int index = static_cast<int>(value);
    if (ImGui::Combo(label, &index, names, static_cast<int>(count))) {
        value = static_cast<Value>(index);
    }
}

constexpr const char* kSpecularNames[] = {"GGX", "Beckmann"};
constexpr const char* kDiffuseNames[] = {"Lambert", "Burley", "Oren-Nayar"};
constexpr const char* kQualityNames[] = {"standard, one lobe", "high, two lobes"};
constexpr const char* kLobesNames[] = {"diffuse alone", "specular alone", "all"};
constexpr const char* kToneMapNames[] = {"none", "Reinhard", "ACES", "Khronos neutral"};

/// A number that a box before it puts in the place of the scene's own.
void overrideSlider(const char* label, std::optional<float>& value) {
    ImGui::PushID(label);
    bool isOn = value.has_value();
    if (ImGui::Checkbox("##on", &isOn)) {
        value = isOn ? std::optional<float>(0.5f) : std::nullopt;
    }
    ImGui::SameLine();
    float number = value.value_or(0.5f);
    if (!isOn) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.4f * ImGui::GetStyle().Alpha);
    const char* const format = isOn ? "%.3f" : "the scene's own";
    if (ImGui::SliderFloat(label, &number, 0.0f, 1.0f, format, ImGuiSliderFlags_AlwaysClamp)) {
        value = number;
    }
    if (!isOn) ImGui::PopStyleVar();
    ImGui::PopID();
}

}  // namespace

Lobes nextLobes(Lobes lobes) {
    return static_cast<Lobes>((static_cast<int>(lobes) + 1) % std::ssize(kLobesNames));
}

ToneMap nextToneMap(ToneMap toneMap) {
    return static_cast<ToneMap>((static_cast<int>(toneMap) + 1) % std::ssize(kToneMapNames));
}

int drawCameraControls(const scene::Scene& cameras, int current) {
    int picked = -1;
    const auto nameOf = [&](int index) {
        const std::string& name = cameras.cameras[static_cast<std::size_t>(index)].name;
        return name.empty() ? fmt::format("camera {}", index) : name;
    };
    if (ImGui::BeginCombo("Camera", nameOf(current).c_str())) {
        for (int i = 0; i < static_cast<int>(cameras.cameras.size()); ++i) {
            ImGui::PushID(i);
            if (ImGui::Selectable(nameOf(i).c_str(), i == current)) picked = i;
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    return picked;
}

void drawLightingControls(ViewSettings& settings) {
    choose("Quality", settings.model.quality, kQualityNames);
    choose("Lobes", settings.lobes, kLobesNames);
    choose("Specular", settings.model.specular, kSpecularNames);
    choose("Diffuse", settings.model.diffuse, kDiffuseNames);
    bool showLights = !settings.hideLights;
    if (ImGui::Checkbox("Lights are seen", &showLights)) settings.hideLights = !showLights;
    ImGui::SameLine();
    ImGui::Checkbox("Two-sided", &settings.twoSided);
}

void drawDisplayControls(ViewSettings& settings, double ev) {
    bool isAutomatic = !settings.exposure.has_value();
    auto shown = static_cast<float>(settings.exposure.value_or(ev));
    if (ImGui::SliderFloat("Exposure", &shown, -8.0f, 20.0f,
                           isAutomatic ? "auto: %.2f EV" : "%.2f EV")) {
        settings.exposure = shown;
        isAutomatic = false;
    }
    choose("Tone map", settings.toneMap, kToneMapNames);
    bool isTransparent = !settings.background.has_value();
    glm::vec3 color = settings.background.value_or(glm::vec3(0.0f));
    if (ImGui::DragFloat3("Background", &color[0], 1.0f, 0.0f, 1e5f, "%.4g",
                          ImGuiSliderFlags_AlwaysClamp)) {
        settings.background = color;
    }
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Radiance behind the scene: R, G, B in nits");
    ImGui::SliderInt("Samples", &settings.sampleCount, 1, 64, "%d", ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Positions in a pixel, of a picture at rest");
    if (ImGui::Checkbox("Auto exposure", &isAutomatic)) {
        settings.exposure = isAutomatic ? std::nullopt : std::optional<double>(ev);
    }
    ImGui::SameLine();
    if (ImGui::Checkbox("Transparent", &isTransparent)) {
        settings.background = isTransparent ? std::nullopt : std::optional(glm::vec3(0.0f));
    }
}

void drawMaterialControls(ViewSettings& settings) {
    overrideSlider("Roughness", settings.roughness);
    overrideSlider("Metalness", settings.metalness);
}

void drawReferenceControls(SplitView& split) {
    using Mode = SplitView::Mode;
    int mode = static_cast<int>(split.mode());
    bool isPicked = false;
    isPicked |= ImGui::RadioButton("Off", &mode, static_cast<int>(Mode::off));
    ImGui::SameLine();
    isPicked |= ImGui::RadioButton("Truth", &mode, static_cast<int>(Mode::reference));
    ImGui::SameLine();
    isPicked |= ImGui::RadioButton("Error", &mode, static_cast<int>(Mode::error));
    if (isPicked) split.setMode(static_cast<Mode>(mode));
    ImGui::SameLine();
    ImGui::Checkbox("Shadows", &split.shadows);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("Ray-traced surfaces block lights; Polylume's picture has no shadows");
    }
    float percent = 100.0f * split.hottestError;
    if (ImGui::SliderFloat("Error scale", &percent, 1.0f, 200.0f, "%.0f %%",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) {
        split.hottestError = 0.01f * percent;
    }
    if (split.mode() != Mode::off) ImGui::TextWrapped("%s", split.status().c_str());
}

}  // namespace polylume::viewer
