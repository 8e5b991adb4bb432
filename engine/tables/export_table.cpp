// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "tables/export_table.hpp"

#include <span>
#include <string>

#include "core/file.hpp"
#include "tables/classic_textures.hpp"
#include "tables/table_file.hpp"
#include "tables/table_text.hpp"

namespace polylume::tables {
namespace {

void writeText(const std::filesystem::path& path, const std::string& text) {
    writeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace

std::vector<std::filesystem::path> exportTable(const std::filesystem::path& path,
                                               const ltc::Table& table, DdsPrecision precision) {
    const ExportFormat format = exportFormatOf(path);
    checkWritable(path);
    switch (format) {
        case ExportFormat::exr:
            writeTable(path, table);
            return {path, rawTablePath(path)};
        case ExportFormat::raw:
            writeFile(path, table.toRaw());
            break;
        case ExportFormat::cHeader:
            writeText(path, cHeader(table, cIdentifier(path.stem().string())));
            break;
        case ExportFormat::json:
            writeText(path, tableJson(table));
            break;
        case ExportFormat::classic:
            writeClassic(path, classicTextures(table, precision));
            return {firstTexturePath(path), secondTexturePath(path)};
    }
    return {path};
}

}  // namespace polylume::tables
