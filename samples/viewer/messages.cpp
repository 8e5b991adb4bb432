// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "messages.hpp"

#include <imgui.h>

#include <algorithm>

#include "core/log.hpp"

namespace polylume::viewer {
namespace {

constexpr double kNewsSeconds = 12.0;

ImVec2 toImGui(const glm::dvec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

}  // namespace

void Messages::say(const std::string& text) {
    log(LogLevel::info, text);
    news_ = text;
    since_ = -1.0;
}

void Messages::showError(const std::string& text) {
    log(LogLevel::warning, text);
    error_ = text;
}

void Messages::draw(const ViewTransform& view, float scale, double now) {
    const float gap = 12.0f * scale;
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoMove;
    const float width = std::max(static_cast<float>(view.size.x) - 2.0f * gap, 100.0f);
    const ImVec2 origin = toImGui(view.origin);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f * scale);
    if (!error_.empty()) {
        ImGui::SetNextWindowPos({origin.x + gap, origin.y + gap});
        ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, 1e4f});
        ImGui::PushStyleColor(ImGuiCol_WindowBg, {0.36f, 0.09f, 0.08f, 0.95f});
        if (ImGui::Begin("error", nullptr, kFlags)) {
            ImGui::PushTextWrapPos(width - 2.0f * gap);
            ImGui::TextUnformatted(error_.c_str());
            ImGui::PopTextWrapPos();
            if (ImGui::SmallButton("Close")) error_.clear();
        }
        ImGui::End();
        ImGui::PopStyleColor();
    }
    if (!news_.empty() && since_ < 0.0) since_ = now;
    if (now - since_ > kNewsSeconds) news_.clear();
    if (!news_.empty()) {
        ImGui::SetNextWindowPos({origin.x + gap, origin.y + static_cast<float>(view.size.y) - gap},
                                ImGuiCond_Always, {0.0f, 1.0f});
        ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {width, 1e4f});
        ImGui::SetNextWindowBgAlpha(0.85f);
        if (ImGui::Begin("news", nullptr, kFlags | ImGuiWindowFlags_NoInputs)) {
            ImGui::PushTextWrapPos(width - 2.0f * gap);
            ImGui::TextUnformatted(news_.c_str());
            ImGui::PopTextWrapPos();
        }
        ImGui::End();
    }
    ImGui::PopStyleVar();
}

void drawNotice(const ViewTransform& view, float scale, const std::string& text, double fraction) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 middle = toImGui(view.origin + 0.5 * view.size);
    list.AddText({middle.x - 0.5f * size.x, middle.y - 0.5f * size.y}, IM_COL32(200, 200, 204, 255),
                 text.c_str());
    if (fraction < 0.0) return;
    const float half = 110.0f * scale;
    const float top = middle.y + size.y + 4.0f * scale;
    list.AddRectFilled({middle.x - half, top}, {middle.x + half, top + 4.0f * scale},
                       IM_COL32(60, 60, 62, 255), 2.0f * scale);
    list.AddRectFilled(
        {middle.x - half, top},
        {middle.x - half + 2.0f * half * static_cast<float>(fraction), top + 4.0f * scale},
        IM_COL32(237, 168, 74, 255), 2.0f * scale);
}

}  // namespace polylume::viewer
