// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace polylume::cli {

/// Adds `polylume table` with all its subcommands and flags to `app`. Parsing sets `work` to what
/// is to be done, and leaves it as it is where another command was given.
void addTableCommand(CLI::App& app, std::function<void()>& work);

}  // namespace polylume::cli
