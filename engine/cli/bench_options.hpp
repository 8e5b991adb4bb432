// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/bench_command.hpp"

namespace polylume::cli {

/// Adds `polylume bench` with all its flags to `app`; parsing fills `command`, which outlives
/// `app`.
CLI::App* addBenchCommand(CLI::App& app, BenchCommand& command);

}  // namespace polylume::cli
