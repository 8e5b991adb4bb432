// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace polylume::scene {

/// The triangles of a glTF primitive of `mode` 4 (triangles), 5 (strip) or 6 (fan), three indices
/// each, counter-clockwise as the specification orders them (section 3.7.2.1); what is left of an
/// incomplete one is dropped. None for points and lines.
std::optional<std::vector<std::uint32_t>> triangleList(std::vector<std::uint32_t> indices,
                                                       int mode);

}  // namespace polylume::scene
