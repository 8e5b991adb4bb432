/* SPDX-FileCopyrightText: 2026 The Polylume authors
 * SPDX-License-Identifier: MIT */

/* What both test hosts bring of their own: a context, a loader that is none of Polylume's, checks,
 * and a G-buffer in Polylume's layout. C99 and C++. */

#ifndef POLYLUME_TEST_HOST_H
#define POLYLUME_TEST_HOST_H

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <glad/gl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* With glad's --mx as Polylume has it, but of another OpenGL, so that functions and struct of the
 * one are no use to the other. */
static GladGLContext gl;

static int failureCount = 0;

static void check(int holds, const char* what, int line) {
    if (holds) return;
    ++failureCount;
    fprintf(stderr, "line %d: expected %s\n", line, what);
}
#define CHECK(condition) check((condition) ? 1 : 0, #condition, __LINE__)

/* Makes a context current that needs neither a window nor a display. */
static void makeContext(void) {
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
    EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    EGLContext context = EGL_NO_CONTEXT;
    if (eglInitialize(display, NULL, NULL) && eglBindAPI(EGL_OPENGL_API)) {
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    }
    if (context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) ||
        gladLoadGLContext(&gl, eglGetProcAddress) == 0) {
        fprintf(stderr, "no EGL context of OpenGL 4.5\n");
        exit(2);
    }
}

enum { kSide = 4 };

static GLuint makeTexture(GLenum storage, GLenum format, const float* texel) {
    GLuint texture = 0;
    float texels[kSide * kSide * 4];
    int channels = format == GL_RGBA ? 4 : format == GL_RG ? 2 : 1;
    int i;
    for (i = 0; i < kSide * kSide * channels; ++i) texels[i] = texel[i % channels];
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, storage, kSide, kSide);
    gl.TextureSubImage2D(texture, 0, 0, 0, kSide, kSide, format, GL_FLOAT, texels);
    return texture;
}

static const float kAlbedo = 0.6f; /* Exact in 16 bits: 39321 / 65535. */
static const float kEmission[3] = {1.0f, 2.0f, 3.0f};

/* A matt surface at x = -1 that faces +x, as the camera below sees it. */
static void makeGBuffer(GLuint textures[5]) {
    const float normal[2] = {1.0f, 0.0f}; /* Octahedral. */
    const float diffuseRoughness[4] = {kAlbedo, kAlbedo, kAlbedo, 0.4f};
    const float specular[4] = {0.0f, 0.0f, 0.0f, 0.0f};
    const float emission[4] = {kEmission[0], kEmission[1], kEmission[2], 1.0f};
    const float depth[1] = {0.1f};
    textures[0] = makeTexture(GL_RG32F, GL_RG, normal);
    textures[1] = makeTexture(GL_RGBA16, GL_RGBA, diffuseRoughness);
    textures[2] = makeTexture(GL_RGBA16, GL_RGBA, specular);
    textures[3] = makeTexture(GL_RGBA32F, GL_RGBA, emission);
    textures[4] = makeTexture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, depth);
}

/* 90 degrees, reversed depth: 0.1 / distance. Column by column. */
static void infinitePerspective(double clipFromView[16]) {
    memset(clipFromView, 0, 16 * sizeof(double));
    clipFromView[0] = clipFromView[5] = 1.0;
    clipFromView[11] = -1.0;
    clipFromView[14] = 0.1;
}

/* Looks along -x. */
static void sideways(double worldFromView[16]) {
    memset(worldFromView, 0, 16 * sizeof(double));
    worldFromView[2] = -1.0;
    worldFromView[5] = worldFromView[8] = worldFromView[15] = 1.0;
}

/* In the plane of the camera, so wide that the surface sees nothing else: form factor 1. Emits
 * toward -x. */
static const float kWideRectangle[12] = {0.0f, -1e5f, -1e5f, 0.0f, -1e5f, 1e5f,
                                         0.0f, 1e5f,  1e5f,  0.0f, 1e5f,  -1e5f};
static const float kRadiance[3] = {1000.0f, 500.0f, 250.0f};

/* Whether a pixel of an RGBA32F texture holds `times` the radiance that a form factor of 1 gives
 * the surface, and `emissionTimes` what it emits. The form factor is a sum of four float32 edges,
 * each within some 1e-7. */
static int holdsRadiance(GLuint texture, float times, float emissionTimes) {
    float pixel[4];
    int i, holds = 1;
    gl.GetTextureSubImage(texture, 0, kSide - 1, kSide - 1, 0, 1, 1, 1, GL_RGBA, GL_FLOAT,
                          sizeof(pixel), pixel);
    for (i = 0; i < 3; ++i) {
        float expected = times * kAlbedo * kRadiance[i] + emissionTimes * kEmission[i];
        if (fabsf(pixel[i] - expected) <= 5e-6f * expected) continue;
        fprintf(stderr, "channel %d: expected %.9g, found %.9g\n", i, expected, pixel[i]);
        holds = 0;
    }
    return holds;
}

static int endHost(const char* name) {
    GLenum error = gl.GetError();
    check(error == GL_NO_ERROR, "no OpenGL error", __LINE__);
    printf("%s: %s, %d failures\n", name, (const char*)gl.GetString(GL_RENDERER), failureCount);
    return failureCount == 0 ? 0 : 1;
}

#endif
