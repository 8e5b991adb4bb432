// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "stats_panel.hpp"

#include <fmt/format.h>
#include <imgui.h>

namespace polylume::viewer {
namespace {

void row(const std::string& name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name.c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
}

/// "1.23 G"
std::string shortNumber(double value) {
    constexpr const char* kUnits[] = {"", " k", " M", " G", " T"};
    int unit = 0;
    while (value >= 1000.0 && unit < 4) {
        value /= 1000.0;
        ++unit;
    }
    return fmt::format("{:.3g}{}", value, kUnits[unit]);
}

}  // namespace

double lightsPerSecond(int lightCount, int litPixelCount, double lightingMilliseconds) {
    if (!(lightingMilliseconds > 0.0)) return 0.0;
    return 1e3 * lightCount * litPixelCount / lightingMilliseconds;
}

void drawStatistics(ViewRenderer& renderer, const SceneDocument& document, double frameMilliseconds,
                    const std::string& backend) {
    PassClock& clock = renderer.clock();
    const glm::ivec2 size = renderer.size();
    const glm::ivec2 drawn = renderer.drawnSize();
    const auto areaLightCount = static_cast<int>(document.lights.areaLights.size());
    const auto punctualCount = static_cast<int>(document.lights.punctualLights.size());
    if (!ImGui::BeginTable("statistics", 2, ImGuiTableFlags_SizingStretchProp)) return;
    row("Picture", fmt::format("{} x {}, {} of {} samples", size.x, size.y, renderer.frameCount(),
                               renderer.settings().sampleCount));
    if (drawn != size) row("Drawn, moving", fmt::format("{} x {}", drawn.x, drawn.y));
    row("Triangles", fmt::format("{}", document.triangleCount));
    row("Lights", fmt::format("{} area, {} punctual", areaLightCount, punctualCount));
    row("Frame", fmt::format("{:.1f} ms", frameMilliseconds));
    double sum = 0.0;
    for (const PassClock::Time& time : clock.collect()) {
        row("  " + time.pass, fmt::format("{:.2f} ms", time.milliseconds));
        sum += time.milliseconds;
    }
    row("  GPU, all", fmt::format("{:.2f} ms", sum));
    const double rate = lightsPerSecond(areaLightCount + punctualCount, renderer.litPixelCount(),
                                        clock.milliseconds("lighting"));
    row("Lights a second", rate > 0.0 ? shortNumber(rate) : "-");
    ImGui::EndTable();
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip(
            "Lights a second: lights x lit pixels / time of the lighting pass.\n"
            "Times are of the GPU, by timer queries, of the last frame drawn.");
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", backend.c_str());
    ImGui::PopStyleColor();
}

}  // namespace polylume::viewer
