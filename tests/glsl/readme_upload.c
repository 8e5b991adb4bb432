/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

#include "readme_upload.h"

static const GladGLContext* gl;

/* The README's code calls OpenGL as most programs do. */
#define glGenTextures gl->GenTextures
#define glBindTexture gl->BindTexture
#define glTexImage3D gl->TexImage3D
#define glTexParameteri gl->TexParameteri

GLuint uploadTable(const char* path);

#include "readme_upload.inc"

GLuint uploadTableFile(const GladGLContext* functions, const char* path) {
    gl = functions;
    return uploadTable(path);
}
