// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace polylume {

/// The G-buffer's encoding of a unit vector as glsl/surface/octahedral.glsl has it (Meyer et al.
/// 2010).
inline glm::vec2 octahedralEncode(const glm::vec3& direction) {
    const glm::vec2 p = glm::vec2(direction) /
                        (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
    const glm::vec2 sign(p.x >= 0.0f ? 1.0f : -1.0f, p.y >= 0.0f ? 1.0f : -1.0f);
    const glm::vec2 folded = (1.0f - glm::vec2(std::abs(p.y), std::abs(p.x))) * sign;
    return direction.z >= 0.0f ? p : folded;
}

inline glm::vec3 octahedralDecode(const glm::vec2& encoded) {
    glm::vec3 direction(encoded, 1.0f - std::abs(encoded.x) - std::abs(encoded.y));
    const float fold = std::max(-direction.z, 0.0f);
    direction.x += direction.x >= 0.0f ? -fold : fold;
    direction.y += direction.y >= 0.0f ? -fold : fold;
    return glm::normalize(direction);
}

}  // namespace polylume
