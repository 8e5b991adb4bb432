// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <functional>

#include "cli/bench_options.hpp"
#include "cli/compare_options.hpp"
#include "cli/figures_options.hpp"
#include "cli/fit_options.hpp"
#include "cli/info_options.hpp"
#include "cli/reference_options.hpp"
#include "cli/render_options.hpp"
#include "cli/table_options.hpp"
#include "cli/terminal.hpp"
#include "cli/version.hpp"
#include "cli/view_command.hpp"

namespace polylume::cli {
namespace {

constexpr int kFailed = 1;
constexpr int kBadUsage = 2;

int runMain(int argc, char** argv) {
    CLI::App app("Polylume: area lighting by linearly transformed cosines");
    app.name("polylume");
    app.set_version_flag("--version", fmt::format("polylume {}", kVersion));
    app.require_subcommand(0, 1);
    bool verbose = false;
    bool quiet = false;
    app.fallthrough();
    app.add_flag("-v,--verbose", verbose, "Say more, OpenGL's own messages included");
    app.add_flag("-q,--quiet", quiet, "Say warnings and errors alone")->excludes("--verbose");
    app.footer("Exit codes: 0 done, 1 failed, 2 bad usage.");

    RenderCommand render;
    ReferenceCommand reference;
    CompareCommand compare;
    FiguresCommand figures;
    FitCommand fit;
    InfoCommand info;
    ViewCommand view;
    BenchCommand bench;
    const CLI::App* renderApp = addRenderCommand(app, render);
    const CLI::App* referenceApp = addReferenceCommand(app, reference);
    const CLI::App* viewApp = addViewCommand(app, view);
    const CLI::App* infoApp = addInfoCommand(app, info);
    const CLI::App* compareApp = addCompareCommand(app, compare);
    const CLI::App* figuresApp = addFiguresCommand(app, figures);
    const CLI::App* fitApp = addFitCommand(app, fit);
    const CLI::App* benchApp = addBenchCommand(app, bench);
    std::function<void()> tableWork;
    addTableCommand(app, tableWork);
    try {
        app.parse(argc, argv);
        // Not by require_subcommand(1), which would hide what was found in its place.
        if (app.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? EXIT_SUCCESS : kBadUsage;
    }

    logToStandardError(verbose ? LogLevel::debug : quiet ? LogLevel::warning : LogLevel::info);
    try {
        if (renderApp->parsed()) run(render);
        if (referenceApp->parsed()) run(reference);
        if (compareApp->parsed() && !run(compare)) return kFailed;
        if (figuresApp->parsed()) run(figures);
        if (fitApp->parsed()) run(fit);
        if (benchApp->parsed()) run(bench);
        if (infoApp->parsed()) run(info);
        if (viewApp->parsed()) {
            if (verbose) view.arguments.emplace_back("-v");
            if (quiet) view.arguments.emplace_back("-q");
            run(view);
        }
        if (tableWork) tableWork();
    } catch (const std::exception& error) {
        fmt::print(stderr, "polylume: error: {}\n", error.what());
        return kFailed;
    }
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace polylume::cli

int main(int argc, char** argv) {
    return polylume::cli::runMain(argc, argv);
}
