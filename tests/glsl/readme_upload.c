/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

#include "readme_upload.h"

static const GladGLContext* gl;

/* The README's code calls OpenGL as most programs do. */
#define glGenTextures gl->GenTextures
#define glBindTexture gl->BindTexture
#define glTexImage3D gl->TexImage3D
#define glTexParameteri gl->TexParameteri

#define uploadTable uploadGgx
#include "readme_upload_ggx.inc"
#undef uploadTable

#define uploadTable uploadGgxTwoLobes
#include "ggx_two_lobes.h"
#include "readme_upload_ggx_two_lobes.inc"
#undef uploadTable

GLuint uploadOneLobe(const GladGLContext* functions) {
    gl = functions;
    return uploadGgx();
}

GLuint uploadTwoLobes(const GladGLContext* functions) {
    gl = functions;
    return uploadGgxTwoLobes();
}
