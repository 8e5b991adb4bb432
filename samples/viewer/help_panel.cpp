// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "help_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstddef>

namespace polylume::viewer {
namespace {

struct Entry {
    const char* keys;  ///< Null: a heading.
    const char* meaning;
};

constexpr Entry kLeft[] = {
    {nullptr, "View"},
    {"Left drag", "orbit (Alt: also over lights)"},
    {"Middle, Shift + left drag", "pan"},
    {"Wheel", "nearer, farther"},
    {"Right held + W A S D, Q E", "fly (wheel: speed, Shift: fast)"},
    {"F", "look at the selected light, or all"},
    {"Home", "back to the scene's camera"},
    {"C", "next camera of the scene"},
    {"R", "split view with the reference"},
    {"E", "error map"},
    {"Tab", "hide and show the panel"},
    {"F1", "this help"},
};
constexpr Entry kRight[] = {
    {nullptr, "Picture"},
    {"[  ]", "darker, brighter by 1/3 EV"},
    {"A", "automatic exposure"},
    {"T", "next tone map"},
    {"Q", "quality: one or two lobes"},
    {"L", "diffuse, specular, all"},
    {"H", "hide and show lights"},
    {"F12, Shift + F12", "screenshot as PNG, as EXR"},
    {"Ctrl + S", "save the scene"},
    {"F5", "read scene and shaders again"},
    {nullptr, "Lights"},
    {"Click", "select"},
    {"1  2  3  4", "move, turn, resize, no handles"},
    {"X", "world or local axes"},
    {"Ctrl + D, Delete", "duplicate, delete"},
    {"Ctrl + Z, Ctrl + Y", "undo, redo"},
    {"Escape", "deselect, close"},
};

template <std::size_t count>
void drawColumn(const char* name, const Entry (&entries)[count], float scale) {
    float keysWidth = 0.0f;
    float meaningWidth = 0.0f;
    for (const Entry& entry : entries) {
        if (entry.keys == nullptr) continue;
        keysWidth = std::max(keysWidth, ImGui::CalcTextSize(entry.keys).x);
        meaningWidth = std::max(meaningWidth, ImGui::CalcTextSize(entry.meaning).x);
    }
    const float gap = 20.0f * scale;
    // Of a table in a window that fits its contents the width is to be said.
    if (!ImGui::BeginTable(name, 2, 0, {keysWidth + meaningWidth + 2.0f * gap, 0.0f})) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, keysWidth + gap);
    ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
    for (const Entry& entry : entries) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        if (entry.keys == nullptr) {
            ImGui::Dummy({0.0f, 0.3f * ImGui::GetTextLineHeight()});
            ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", entry.meaning);
            continue;
        }
        ImGui::TextUnformatted(entry.keys);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", entry.meaning);
    }
    ImGui::EndTable();
}

}  // namespace

void drawHelp(bool& isOpen, float scale) {
    if (!isOpen) return;
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5f * io.DisplaySize.x, 0.5f * io.DisplaySize.y}, ImGuiCond_Always,
                            {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f},
                                        {0.96f * io.DisplaySize.x, 0.96f * io.DisplaySize.y});
    ImGui::SetNextWindowBgAlpha(0.96f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8.0f * scale);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {18.0f * scale, 14.0f * scale});
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("Keys and mouse", &isOpen, kFlags)) {
        ImGui::BeginGroup();
        drawColumn("left", kLeft, scale);
        ImGui::EndGroup();
        // Beside each other where there is room.
        if (io.DisplaySize.x > 2.2f * ImGui::GetItemRectSize().x) ImGui::SameLine();
        ImGui::BeginGroup();
        drawColumn("right", kRight, scale);
        ImGui::EndGroup();
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace polylume::viewer
