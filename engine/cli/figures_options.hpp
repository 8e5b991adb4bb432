// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/figures_command.hpp"

namespace polylume::cli {

/// Adds `polylume figures` with all its flags to `app`; parsing fills `command`, which outlives
/// `app`.
CLI::App* addFiguresCommand(CLI::App& app, FiguresCommand& command);

}  // namespace polylume::cli
