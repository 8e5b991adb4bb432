// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <filesystem>
#include <vector>

#include "ltc/table.hpp"
#include "tables/dds_format.hpp"

namespace polylume::tables {

/// Writes `table` in the format that the extension of `path` says (exportFormatOf()): .exr with its
/// raw form beside it, .f32 (raw), .h, .json, or .dds, which makes two files whose names end in _1
/// and _2, of `precision`. Gives the names of what it wrote. Throws Error; what was there before
/// stays then.
std::vector<std::filesystem::path> exportTable(const std::filesystem::path& path,
                                               const ltc::Table& table, DdsPrecision precision);

}  // namespace polylume::tables
