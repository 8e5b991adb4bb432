// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/fit_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "brdf/registry.hpp"
#include "cli/flags.hpp"

namespace polylume::cli {
namespace {

/// Bad usage that only two flags together show.
void checkTogether(const FitCommand& command, const CLI::Option* roughness) {
    if (command.output.extension() != ".exr") {
        reject("--output", "a file name that ends in .exr", command.output.string());
    }
    if (roughness->count() > 0 && !command.options.viewOnly) {
        reject("--roughness", "--view-only beside it, for a table of that roughness alone",
               roughness->as<std::string>());
    }
}

}  // namespace

CLI::App* addFitCommand(CLI::App& app, FitCommand& command) {
    CLI::App* fit = app.add_subcommand("fit", "Fit an LTC table to a BRDF");
    fit->footer(
        "Examples:\n"
        "  polylume fit --brdf ggx -o ggx.exr\n"
        "  polylume fit --brdf ggx --lobe-count 2 -o ggx_two_lobes.exr\n"
        "  polylume fit --brdf beckmann --solver moments --size 32 -o quick.exr\n"
        "  polylume fit --brdf merl:blue-paint.binary -o blue-paint.exr\n"
        "  polylume fit --brdf burley --view-only --roughness 0.7 -o burley.exr\n"
        "\n"
        "Writes the table as OpenEXR and, beside it, as raw float32 (.f32); see tables/README.md.\n"
        "The same flags give the same bytes, on any number of threads.");
    fit->add_option("--brdf", command.brdf,
                    fmt::format("BRDF to fit: {}, or merl:FILE for a measured one of the MERL "
                                "database",
                                fmt::join(brdf::brdfNames(), ", ")))
        ->required()
        ->option_text("NAME");
    fit->add_option("-o,--output", command.output, "Table to write: .exr")
        ->required()
        ->option_text("FILE");
    addChoice<fit::Solver>(
        *fit, "--solver", command.options.solver,
        {{"lm", fit::Solver::lm}, {"moments", fit::Solver::moments}},
        "How lobes are found: Levenberg-Marquardt, or closed form, fast and rougher; default lm");
    fit->add_option("--lobe-count", command.options.lobeCount, "Lobes at each node; default 1")
        ->check(CLI::Range(1, ltc::kMaxLobeCount))
        ->option_text("1|2");
    fit->add_option("--size", command.options.size, "Nodes along each axis, 16 to 256; default 64")
        ->check(CLI::Range(16, 256))
        ->option_text("N");
    fit->add_flag("--view-only", command.options.viewOnly,
                  "One column, over view angle alone, at --roughness");
    const CLI::Option* roughness =
        addNumber(*fit, "--roughness", command.options.viewRoughness, 0.0, 1.0,
                  "Roughness of a --view-only table; default 0.5")
            ->option_text("R");
    addThreads(*fit, command.options.threadCount);
    fit->final_callback([&command, roughness] { checkTogether(command, roughness); });
    return fit;
}

}  // namespace polylume::cli
