// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "context/context.hpp"
#include "image/display_transform.hpp"
#include "render/renderer.hpp"

namespace polylume::cli {

struct RenderCommand {
    std::filesystem::path scene;
    std::filesystem::path output;  ///< .exr or .png
    Backend backend = Backend::automatic;
    std::string camera;              ///< Name or index; empty: the first.
    std::optional<double> exposure;  ///< EV; none: automatic.
    ToneMap toneMap = ToneMap::aces;
    std::filesystem::path table;   ///< Specular table; empty: the built-in one.
    std::filesystem::path lights;  ///< Empty: the scene's own.
    std::optional<std::filesystem::path> glslDir;
    RenderOptions options;
};

/// Renders a glTF file to a picture. Throws Error.
void run(const RenderCommand& command);

}  // namespace polylume::cli
