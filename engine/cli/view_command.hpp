// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace polylume::cli {

/// What `polylume view` hands on; its flags are those of the program polylume-view.
struct ViewCommand {
    std::vector<std::string> arguments;
};

/// Adds `polylume view` to `app`; parsing fills `command`, which outlives `app`.
CLI::App* addViewCommand(CLI::App& app, ViewCommand& command);

/// The program polylume-view beside the one that runs.
std::filesystem::path viewerPath();

/// Goes on as `viewer` with the command's arguments, and returns only by throwing Error: where
/// there is no such program, or it can't be started.
[[noreturn]] void run(const ViewCommand& command,
                      const std::filesystem::path& viewer = viewerPath());

}  // namespace polylume::cli
