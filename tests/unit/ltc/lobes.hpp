// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "ltc/builtin_table.hpp"
#include "ltc/table_layout.hpp"

// Lobes that the tests of this folder share.
namespace polylume::ltc::testing {

inline const Lobe kCosine{};                          // The identity.
inline const Lobe kTilted{0.4, 0.5, -0.12, 0.2};      // A lobe that leans towards -x.
inline const Lobe kGrazing{0.07, 0.26, -0.03, 0.09};  // Partly below the surface.

inline const Table& ggx() {
    return builtinTable(BuiltinTable::ggx);
}

}  // namespace polylume::ltc::testing
