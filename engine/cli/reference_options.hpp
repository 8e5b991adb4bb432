// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>

#include "cli/reference_command.hpp"

namespace polylume::cli {

/// Adds `polylume reference` with all its flags to `app`; parsing fills `command`, which outlives
/// `app`.
CLI::App* addReferenceCommand(CLI::App& app, ReferenceCommand& command);

}  // namespace polylume::cli
