// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene_document.hpp"
#include "view_renderer.hpp"

namespace polylume::viewer {

/// What `polylume render` needs to know to give the picture in the window.
struct RenderCommandText {
    std::filesystem::path scene;
    std::filesystem::path output;
    std::optional<int> camera;     ///< None: the first.
    std::filesystem::path lights;  ///< Empty: the scene's own.
    bool emissiveLights = false;
    glm::ivec2 size{1};
};

/// The command line, for a shell.
std::string commandLine(const RenderCommandText& text, const ViewSettings& settings);

/// The first of "stem-1.png", "stem-2.png", ... in the working directory that does not exist.
std::filesystem::path freeName(const std::string& stem, const std::string& extension);

/// Writes the picture in the window as `polylume render` would: all its samples, an EXR in nits, or
/// a PNG as it is shown. Throws Error.
void savePicture(const std::filesystem::path& output, ViewRenderer& renderer,
                 const SceneDocument& document, const std::string& backend);

}  // namespace polylume::viewer
