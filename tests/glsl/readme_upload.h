/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */
#pragma once

#include <glad/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The host code of glsl/ltc/README.md, through the functions of a current context: a texture array
 * of a table's .f32, 0 where that is no table of 64x64 nodes. */
GLuint uploadTableFile(const GladGLContext* functions, const char* path);

#ifdef __cplusplus
}
#endif
