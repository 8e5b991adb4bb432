// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>

namespace polylume::tables {

/// The binary16 of IEEE 754-2008 nearest to `value`, ties to even; infinity where it is too large.
std::uint16_t halfOf(float value);

/// The value of a binary16, which a float holds exactly.
float floatOf(std::uint16_t half);

}  // namespace polylume::tables
