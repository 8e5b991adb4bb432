// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "ltc/table.hpp"

namespace polylume::ltc {

/// The tables that are compiled into the library (tables/README.md).
enum class BuiltinTable {
    ggx,
    ggxTwoLobes,
    beckmann,
    beckmannTwoLobes,
    burley,
    orenNayar,
    charlie
};

/// Parses the table at the first call. May be called from several threads at once.
const Table& builtinTable(BuiltinTable table);

}  // namespace polylume::ltc
