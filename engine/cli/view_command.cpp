// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/view_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "polylume/error.hpp"

namespace polylume::cli {

namespace fs = std::filesystem;

CLI::App* addViewCommand(CLI::App& app, ViewCommand& command) {
    CLI::App* view = app.add_subcommand(
        "view", "Look at a scene in a window, edit its lights, compare with the reference");
    // All that follows is for the other program, --help too.
    view->set_help_flag();
    view->fallthrough(false);
    view->prefix_command();
    view->final_callback([view, &command] { command.arguments = view->remaining(); });
    return view;
}

fs::path viewerPath() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    return program.parent_path() / "polylume-view";
}

void run(const ViewCommand& command, const fs::path& viewer) {
    if (!fs::exists(viewer)) {
        throw Error(fmt::format(
            "expected the program polylume-view beside this one, found no {}: it is left out where "
            "GLFW 3.3 or Dear ImGui 1.86 is missing when Polylume is configured; install them "
            "(Debian: libglfw3-dev libimgui-dev), configure and build again",
            viewer.string()));
    }
    std::vector<std::string> arguments = {viewer.string()};
    arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    ::execv(viewer.c_str(), pointers.data());
    throw Error(fmt::format("can't start {}: {}", viewer.string(), std::strerror(errno)));
}

}  // namespace polylume::cli
