// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/fit_command.hpp"

namespace polylume::cli {

/// Adds `polylume fit` with all its flags to `app`; parsing fills `command`, which outlives `app`.
CLI::App* addFitCommand(CLI::App& app, FitCommand& command);

}  // namespace polylume::cli
