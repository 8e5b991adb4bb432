// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/functions.hpp"
#include "polylume/area_lighting.hpp"

// A frame's inputs, looked at before anything is bound, so that no bad one causes an OpenGL error.
// All need the context current and throw Error that says which input is meant.
namespace polylume::embed {

/// The format of the target's texture; 0 where it is a framebuffer.
GLenum checkTarget(const gl::Functions& gl, const LightingFrame& frame, LightingStage stage);

/// The size of the G-buffer's textures, which is the frame's at least.
glm::ivec2 checkGBuffer(const gl::Functions& gl, const LightingFrame& frame, bool withSheen);

/// `texture` has colours that can be read as floats, and `what` it is for.
void checkColorTexture(const gl::Functions& gl, GLuint texture, const char* what);

/// The bound draw framebuffer can be drawn to, in draw buffer 0; `name` is its own.
void checkDrawFramebuffer(const gl::Functions& gl, GLuint name, const char* what);

}  // namespace polylume::embed
