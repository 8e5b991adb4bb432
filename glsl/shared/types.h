// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

// Read by C++ and GLSL. A shared file has only mat4, vec4, uvec4, and scalars in fours, so that both sides lay it out
// alike, and each block is declared in the file of its struct.
#ifdef __cplusplus
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace polylume::shared {
using glm::mat4;
using glm::uvec4;
using glm::vec4;
using uint = std::uint32_t;
}  // namespace polylume::shared
#endif
