// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <glad/gl.h>

namespace polylume::gl {

/// The OpenGL 4.5 core functions of one context, as loaded by glad.
using Functions = GladGLContext;

}  // namespace polylume::gl
