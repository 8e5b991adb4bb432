// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glm/glm.hpp>

#include "gl/objects.hpp"
#include "ltc/table.hpp"

namespace polylume {

/// A table on the GPU as glsl/ltc/lobe.glsl reads it.
struct TableTexture {
    gl::Texture texture;  ///< An array: code of lobe 1; albedo, fresnel, share2; code of lobe 2.
    glm::vec2 reference{0.0f};  ///< Of ltcPlace().
    int lobeCount = 1;
};

/// Uploads `table`, a classic one in our own layout. Throws Error as ltc::nativeTable() does.
TableTexture uploadTable(const gl::Functions& gl, const ltc::Table& table, const char* label);

}  // namespace polylume
