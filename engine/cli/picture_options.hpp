// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "cli/picture.hpp"

namespace polylume::cli {

/// Adds the flags that say what of a scene is shown, and how; parsing fills `request` and
/// `options`, which outlive `app`.
void addSceneFlags(CLI::App& app, PictureRequest& request, ViewOptions& options);

/// --size, in pixels.
void addSize(CLI::App& app, glm::ivec2& size, const std::string& description);

/// --quality
CLI::Option* addQuality(CLI::App& app, Quality& quality);

/// Adds the flags that every command has which makes a picture of a scene; parsing fills `request`
/// and `options`, which outlive `app`.
void addPictureFlags(CLI::App& app, PictureRequest& request, ViewOptions& options);

/// Rejects bad usage that only two of these flags together show; for an app's final callback.
void checkPictureFlags(const PictureRequest& request, const ViewOptions& options);

}  // namespace polylume::cli
