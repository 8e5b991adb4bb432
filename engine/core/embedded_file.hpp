// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <string_view>

namespace polylume {

/// A file that was compiled into the program (cmake/EmbedFiles.cmake).
struct EmbeddedFile {
    std::string_view path;                 ///< Relative to the folder that was embedded.
    std::span<const unsigned char> bytes;  ///< Aligned to 16 bytes.
};

}  // namespace polylume
