// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/render_command.hpp"

namespace polylume::cli {

/// Adds `polylume render` with all its flags to `app`; parsing fills `command`, which outlives
/// `app`.
CLI::App* addRenderCommand(CLI::App& app, RenderCommand& command);

}  // namespace polylume::cli
