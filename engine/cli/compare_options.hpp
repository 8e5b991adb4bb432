// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/compare_command.hpp"

namespace polylume::cli {

/// Adds `polylume compare` with all its flags to `app`; parsing fills `command`, which outlives
/// `app`.
CLI::App* addCompareCommand(CLI::App& app, CompareCommand& command);

}  // namespace polylume::cli
