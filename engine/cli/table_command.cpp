// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/table_command.hpp"

#include <fmt/format.h>

#include <iostream>
#include <iterator>
#include <memory>

#include "brdf/registry.hpp"
#include "cli/table_report.hpp"
#include "cli/table_samples.hpp"
#include "cli/terminal.hpp"
#include "core/file.hpp"
#include "figures/error_figure.hpp"
#include "image/image_io.hpp"
#include "polylume/error.hpp"
#include "tables/classic_textures.hpp"
#include "tables/export_table.hpp"
#include "tables/table_file.hpp"

namespace polylume::cli {
namespace {

namespace fs = std::filesystem;

/// The BRDF's name that was asked for, or that the table gives.
std::string brdfNameOf(const ltc::Table& table, const std::string& wanted) {
    return wanted.empty() ? table.attributes().at("brdf") : wanted;
}

std::unique_ptr<brdf::Brdf> makeBrdfOf(const ltc::Table& table, const std::string& wanted) {
    try {
        return brdf::makeBrdf(brdfNameOf(table, wanted));
    } catch (const Error& error) {
        if (!wanted.empty()) throw;
        throw Error(
            fmt::format("{} (the table's attribute \"brdf\"; name it with --brdf, as merl:FILE "
                        "where it was measured)",
                        error.what()));
    }
}

std::string readPoints(const fs::path& path) {
    if (path != "-") return readTextFile(path);
    return {std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
}

fs::path withSuffix(const fs::path& path, std::string_view suffix) {
    return path.parent_path() /
           fmt::format("{}{}{}", path.stem().string(), suffix, path.extension().string());
}

}  // namespace

void run(const TableInfoCommand& command) {
    fmt::print("{}", describeTable(tables::readTable(command.table), command.table.string()));
}

void run(const TableScoreCommand& command) {
    const ltc::Table table = tables::readTable(command.table);
    const std::unique_ptr<brdf::Brdf> brdf = makeBrdfOf(table, command.brdf);
    fit::FullScoreOptions options;
    options.threadCount = command.threadCount;
    fit::FullScore score;
    {
        ProgressBar progress("scoring");
        score = fit::computeFullScore(*brdf, table, options, progress);
    }
    const ScoreTitle title{command.table.filename().string(), brdfNameOf(table, command.brdf)};
    fmt::print("{}",
               command.json ? scoreJson(title, table, score) : scoreText(title, table, score));
}

void run(const TableSampleCommand& command) {
    const ltc::Table table = tables::readTable(command.table);
    const std::string name = command.points == "-" ? "standard input" : command.points.string();
    fmt::print("{}", sampleLines(table, parsePoints(readPoints(command.points), name)));
}

void run(const TableExportCommand& command) {
    const ltc::Table table = tables::readTable(command.table);
    for (const fs::path& path : tables::exportTable(command.output, table, command.precision)) {
        log(LogLevel::info, fmt::format("wrote {}", path.string()));
    }
}

void run(const TableImportCommand& command) {
    tables::checkTablePath(command.output);
    const fs::path second =
        command.second.empty() ? tables::secondTextureBeside(command.first) : command.second;
    const tables::ClassicTable read =
        tables::readClassic(command.first, second, {command.brdf, command.alphaFloor});
    if (read.mendedCount > 0) {
        log(LogLevel::warning,
            fmt::format("{} of {} nodes of {} hold a singular matrix, as half floats make those of "
                        "smooth surfaces; each took its rougher neighbour's values",
                        read.mendedCount, read.table.size().columns * read.table.size().rows,
                        command.first.string()));
    }
    tables::writeTable(command.output, read.table);
    log(LogLevel::info, fmt::format("wrote {} and {}", command.output.string(),
                                    tables::rawTablePath(command.output).string()));
}

void run(const TablePlotCommand& command) {
    const ltc::Table table = tables::readTable(command.table);
    const std::unique_ptr<brdf::Brdf> brdf = makeBrdfOf(table, command.brdf);
    checkWritable(command.output);
    const std::string title = fmt::format("{} against {}", command.table.filename().string(),
                                          brdfNameOf(table, command.brdf));
    const PixelImage errors = figures::drawErrorFigure(*brdf, table, title);
    const PixelImage lobes = figures::drawLobeFigure(*brdf, table, command.cells, title);
    const fs::path errorPath = withSuffix(command.output, "_error");
    const fs::path lobePath = withSuffix(command.output, "_lobes");
    writePng(errorPath, errors, {});
    writePng(lobePath, lobes, {});
    log(LogLevel::info, fmt::format("wrote {} and {}", errorPath.string(), lobePath.string()));
}

}  // namespace polylume::cli
