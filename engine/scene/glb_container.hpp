// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace polylume::scene {

/// The two chunks of a .glb file, pointing into it.
struct GlbChunks {
    std::string_view json;
    std::span<const std::byte> binary;
    bool hasBinary = false;
};

/// Whether the file begins with the magic of a .glb.
bool isGlb(std::span<const std::byte> file);

/// Takes a .glb apart (glTF 2.0 specification, section 4). Throws Error that names the file and the
/// offset where it is not one or is cut short.
GlbChunks splitGlb(std::span<const std::byte> file, const std::string& fileName);

}  // namespace polylume::scene
