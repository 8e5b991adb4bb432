// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/info_command.hpp"

namespace polylume::cli {

/// Adds `polylume info` with all its flags to `app`; parsing fills `command`, which outlives `app`.
CLI::App* addInfoCommand(CLI::App& app, InfoCommand& command);

}  // namespace polylume::cli
