// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <glm/glm.hpp>

namespace polylume::viewer {

/// What the window remembers from one run to the next.
struct ViewerState {
    glm::ivec2 windowSize{1280, 800};  ///< As glfwCreateWindow() takes it.
    std::filesystem::path lastScene;   ///< Absolute; empty for none.

    bool operator==(const ViewerState&) const = default;
};

/// Where the state lies: polylume/view.json below $XDG_STATE_HOME, or below ~/.local/state where
/// that is not set or not absolute (XDG Base Directory Specification 0.8); empty without a home.
std::filesystem::path viewerStatePath();

/// Reads the state. A file that is missing, damaged or senseless gives defaults, value by value;
/// never throws. A last scene that no longer exists is left out.
ViewerState loadViewerState(const std::filesystem::path& path = viewerStatePath());

/// Writes the state by way of a temporary file; makes the folder. Never throws: where it can't be
/// written, the log says so at level `debug` and the window opens with defaults next time.
void saveViewerState(const ViewerState& state,
                     const std::filesystem::path& path = viewerStatePath());

}  // namespace polylume::viewer
