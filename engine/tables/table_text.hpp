// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "ltc/table.hpp"

namespace polylume::tables {

/// A header for C99 and C++ that needs nothing else: the attributes as comments, sizes as macros
/// and the values of the nodes, row by row, as one static array of floats. All names begin with
/// `name`, a C identifier; see cIdentifier(). Every float reads back exactly.
std::string cHeader(const ltc::Table& table, std::string_view name);

/// `text` with everything that C identifiers can't hold replaced by '_'.
std::string cIdentifier(std::string_view text);

/// A JSON object: "attributes" (names and texts), "columns", "rows", "valueNames", and "values",
/// one list of numbers, row by row, that read back exactly.
std::string tableJson(const ltc::Table& table);

/// How export writes a table, by the extension of the name.
enum class ExportFormat { exr, raw, cHeader, json, classic };

/// Of .exr, .f32, .h, .json or .dds. Throws Error for another extension.
ExportFormat exportFormatOf(const std::filesystem::path& path);

}  // namespace polylume::tables
