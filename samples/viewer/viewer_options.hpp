// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>

#include "scene_document.hpp"
#include "view_settings.hpp"

namespace polylume::viewer {

/// What the command line asks for.
struct ViewerOptions {
    SceneRequest request;  ///< Its scene is empty where none was named.
    ViewSettings settings;
    std::optional<glm::ivec2> windowSize;  ///< None: as it was last.
    std::optional<std::filesystem::path> glslDir;
    bool verbose = false;
    bool quiet = false;
};

/// Reads the command line of polylume-view into `options`. Where that ends the program (bad usage,
/// --help, --version) it has printed what is to be said, and returns the exit code.
std::optional<int> parseOptions(int argc, char** argv, ViewerOptions& options);

}  // namespace polylume::viewer
