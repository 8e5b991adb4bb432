// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <optional>

#include "cli/picture.hpp"
#include "context/context.hpp"
#include "render/renderer.hpp"

namespace polylume::cli {

struct RenderCommand {
    PictureRequest request;
    Backend backend = Backend::automatic;
    std::filesystem::path table;  ///< Specular table; empty: the built-in one.
    std::optional<std::filesystem::path> glslDir;
    RenderOptions options;
};

/// Renders a glTF file to a picture. Throws Error.
void run(const RenderCommand& command);

}  // namespace polylume::cli
