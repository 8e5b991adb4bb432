// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/shader_library.hpp"

namespace polylume::bench {

/// The library's shaders, and those of engine/bench/glsl as "bench/NAME".
gl::ShaderLibrary makeShaderLibrary();

}  // namespace polylume::bench
