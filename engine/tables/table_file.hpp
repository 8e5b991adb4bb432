// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>

#include "ltc/table.hpp"

namespace polylume::tables {

/// Writes `table` to `path` (.exr: float32, named channels, attributes) and, beside it with the
/// extension .f32, in the raw form of Table::toRaw(). The same bytes for the same table. Throws
/// Error where `path` has another extension or can't be written; both files are complete before
/// either takes its name, so an old pair stays then.
void writeTable(const std::filesystem::path& path, const ltc::Table& table);

/// Reads a table from either form, by the extension .exr or .f32. Throws Error that names the file
/// where it is no table of this version: channels, sizes, attributes and values are all checked.
ltc::Table readTable(const std::filesystem::path& path);

/// Throws Error where writeTable() would refuse the name or its folder is missing, so that a caller
/// learns it before a long fit.
void checkTablePath(const std::filesystem::path& path);

/// The path of the raw form that lies beside `path`.
std::filesystem::path rawTablePath(const std::filesystem::path& path);

}  // namespace polylume::tables
