// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/table_options.hpp"

#include <fmt/ranges.h>

#include <memory>

#include "brdf/registry.hpp"
#include "cli/flags.hpp"
#include "cli/table_command.hpp"
#include "polylume/error.hpp"
#include "tables/table_text.hpp"

namespace polylume::cli {
namespace {

/// A subcommand whose parsing sets `work` to run it, after `check`.
template <typename Command>
struct Subcommand {
    CLI::App* app;
    std::shared_ptr<Command> command;

    Subcommand(CLI::App& table, const std::string& name, const std::string& description,
               std::function<void()>& work, std::function<void(const Command&)> check = {})
        : app(table.add_subcommand(name, description)), command(std::make_shared<Command>()) {
        app->final_callback([parsed = command, &work, check] {
            if (check) check(*parsed);
            work = [parsed] { run(*parsed); };
        });
    }

    void takesTable() const {
        app->add_option("table", command->table, "Table: .exr, or the raw .f32")
            ->required()
            ->option_text("FILE");
    }

    void takesBrdf() const {
        app->add_option("--brdf", command->brdf,
                        fmt::format("BRDF to compare with: {}, or merl:FILE; default the table's",
                                    fmt::join(brdf::brdfNames(), ", ")))
            ->option_text("NAME");
    }
};

void checkExtension(const std::filesystem::path& output, const std::string& extension) {
    if (output.extension() == extension) return;
    reject("--output", "a file name that ends in " + extension, output.string());
}

figures::LobeCell parseCell(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon != std::string::npos) {
        const auto roughness = parseNumber<double>(std::string_view(text).substr(0, colon));
        const auto degrees = parseNumber<double>(std::string_view(text).substr(colon + 1));
        const bool inRange = roughness && degrees && *roughness >= 0.0 && *roughness <= 1.0 &&
                             *degrees >= 0.0 && *degrees < 90.0;
        if (inRange) return {*roughness, *degrees};
    }
    reject("--cells",
           "ROUGHNESS:DEGREES, apart by commas, from 0 to 1 and from 0 to below 90, as "
           "0.25:60,0.5:75",
           text);
}

std::vector<figures::LobeCell> parseCells(const std::string& text) {
    constexpr std::size_t kMostCells = 24;
    std::vector<figures::LobeCell> cells;
    for (const std::string& cell : CLI::detail::split(text, ',')) cells.push_back(parseCell(cell));
    if (cells.size() > kMostCells) {
        reject("--cells", fmt::format("at most {} cells", kMostCells), text);
    }
    return cells;
}

void addInfo(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TableInfoCommand> info(
        table, "info", "Say what a table holds: size, lobes, attributes, ranges", work);
    info.takesTable();
    info.app->footer("Example:\n  polylume table info tables/ggx.exr");
}

void addScore(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TableScoreCommand> score(
        table, "score", "Measure how far a table is from its BRDF, at nodes and between", work);
    score.takesTable();
    score.takesBrdf();
    score.app->add_flag("--json", score.command->json, "Print JSON in place of text");
    addThreads(*score.app, score.command->threadCount);
    score.app->footer(
        "Examples:\n"
        "  polylume table score tables/ggx.exr\n"
        "  polylume table score imported.exr --brdf ggx --json > score.json\n"
        "\n"
        "The same table gives the same score on every run and any number of threads.");
}

void addSample(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TableSampleCommand> sample(
        table, "sample", "Look a table up as a shader does, and print the values", work);
    sample.takesTable();
    sample.app
        ->add_option("--at", sample.command->points,
                     "Where: a file of lines \"roughness cos_theta_v\", or - for standard input")
        ->required()
        ->option_text("FILE|-");
    sample.app->footer(
        "Example:\n"
        "  echo 0.25 0.5 | polylume table sample tables/ggx.exr --at -\n"
        "\n"
        "For each line, and each lobe from 1 on, prints\n"
        "  roughness cos_theta_v lobe weight m11 m31 m13 m33 albedo fresnel\n"
        "with mRC row R, column C of M^-1 and m22 = 1. f cos = albedo * sum of weight D over the\n"
        "lobes above the surface, and 0 below; D integrates to 1 over the whole sphere. Blank\n"
        "lines and what follows a # are passed over; nothing is printed where a line is bad.");
}

void addExport(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TableExportCommand> exporting(
        table, "export", "Write a table in another format", work,
        [](const TableExportCommand& command) {
            try {
                tables::exportFormatOf(command.output);
            } catch (const Error& error) {
                throw CLI::ValidationError("--output", error.what());
            }
            if (command.precision == tables::DdsPrecision::half &&
                command.output.extension() != ".dds") {
                reject("--half", "an output that ends in .dds", command.output.string());
            }
        });
    exporting.takesTable();
    exporting.app
        ->add_option("-o,--output", exporting.command->output,
                     "File to write: .dds, .h, .json, .f32 or .exr")
        ->required()
        ->option_text("FILE");
    exporting.app->add_flag_callback(
        "--half",
        [command = exporting.command] { command->precision = tables::DdsPrecision::half; },
        "DDS of half floats, which lose smooth surfaces at grazing views");
    exporting.app->footer(
        "Examples:\n"
        "  polylume table export tables/ggx.exr -o ggx.dds      writes ggx_1.dds and ggx_2.dds\n"
        "  polylume table export tables/ggx_two_lobes.exr -o ggx_two_lobes.h\n"
        "\n"
        ".dds   two RGBA textures: m11, m31, m13, m33; albedo/H, fresnel/H, 0, and the horizon's\n"
        "       share of a sphere light. Rows by sqrt(1 - cos theta_v). One lobe.\n"
        ".h     a C array   .json   the same numbers   .f32   raw float32   .exr   with both");
}

void addImport(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TableImportCommand> import(
        table, "import", "Read the two DDS textures that other renderers use", work,
        [](const TableImportCommand& command) { checkExtension(command.output, ".exr"); });
    import.app
        ->add_option("first", import.command->first, "First texture, m11, m31, m13, m33: .dds")
        ->required()
        ->option_text("FIRST");
    import.app
        ->add_option("second", import.command->second,
                     "Second texture, albedo/H and fresnel/H; default NAME_2.dds for NAME_1.dds")
        ->option_text("SECOND");
    import.app->add_option("-o,--output", import.command->output, "Table to write: .exr")
        ->required()
        ->option_text("FILE");
    import.app
        ->add_option("--brdf", import.command->brdf,
                     "BRDF that the table was fitted to; goes into its attributes")
        ->required()
        ->option_text("NAME");
    addNumber(*import.app, "--alpha-floor", import.command->alphaFloor, 0.0, 0.999,
              "Least alpha that was fitted; default 0")
        ->option_text("ALPHA");
    import.app->footer(
        "Examples:\n"
        "  polylume table import ggx_1.dds -o imported.exr --brdf ggx\n"
        "  polylume table import matrices.dds factors.dds -o imported.exr --brdf ggx "
        "--alpha-floor 1e-4\n"
        "\n"
        "Reads half and single floats. Writes the raw form (.f32) too.");
}

void addPlot(CLI::App& table, std::function<void()>& work) {
    const Subcommand<TablePlotCommand> plot(
        table, "plot", "Draw a table's error, and lobes beside the BRDF's", work,
        [](const TablePlotCommand& command) { checkExtension(command.output, ".png"); });
    plot.takesTable();
    plot.app
        ->add_option("-o,--output", plot.command->output,
                     "Pictures to write: NAME_error.png and NAME_lobes.png for NAME.png")
        ->required()
        ->option_text("FILE");
    plot.takesBrdf();
    addParsed(*plot.app, "--cells", plot.command->cells, parseCells,
              "Lobes to draw, as ROUGHNESS:DEGREES from the normal, apart by commas")
        ->option_text("R:THETA,...");
    plot.app->footer(
        "Examples:\n"
        "  polylume table plot tables/ggx.exr -o ggx.png\n"
        "  polylume table plot tables/ggx_two_lobes.exr -o ggx2.png --cells 0.35:80,0.6:60");
}

}  // namespace

void addTableCommand(CLI::App& app, std::function<void()>& work) {
    CLI::App* table = app.add_subcommand("table", "Inspect, score, convert and draw LTC tables");
    // Not by require_subcommand(1), which would hide what was found in its place.
    table->require_subcommand(0, 1);
    table->final_callback([table] {
        if (table->get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
    });
    table->footer(
        "Examples:\n"
        "  polylume table score tables/ggx.exr\n"
        "  polylume table export tables/ggx.exr -o ggx.dds\n"
        "\"polylume table SUBCOMMAND --help\" says more.");
    addInfo(*table, work);
    addScore(*table, work);
    addSample(*table, work);
    addExport(*table, work);
    addImport(*table, work);
    addPlot(*table, work);
}

}  // namespace polylume::cli
