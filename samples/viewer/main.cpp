// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

#include "application.hpp"
#include "cli/terminal.hpp"
#include "viewer_options.hpp"

int main(int argc, char** argv) {
    using namespace polylume;
    viewer::ViewerOptions options;
    if (const std::optional<int> exitCode = viewer::parseOptions(argc, argv, options)) {
        return *exitCode;
    }
    cli::logToStandardError(options.verbose ? LogLevel::debug
                            : options.quiet ? LogLevel::warning
                                            : LogLevel::info);
    try {
        viewer::Application application(options);
        application.run();
    } catch (const std::exception& error) {
        fmt::print(stderr, "polylume view: error: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
