// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

namespace polylume {

/// "1.2.3"
inline constexpr const char* kVersion = POLYLUME_VERSION;

}  // namespace polylume
