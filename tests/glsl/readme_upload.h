/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */
#pragma once

#include <glad/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The host code of glsl/ltc/README.md, through the functions of a current context. Each gives a
 * texture array: of the table ggx, and of ggx_two_lobes. */
GLuint uploadOneLobe(const GladGLContext* functions);
GLuint uploadTwoLobes(const GladGLContext* functions);

#ifdef __cplusplus
}
#endif
