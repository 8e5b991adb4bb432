// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>

#include "gl/functions.hpp"

namespace polylume::gl {

/// What setPictureState() turns off, beside blending and the scissor test of draw buffer and
/// viewport 0: each could keep fragments of a triangle over the picture from being drawn as they
/// are. A clip distance that a shader does not write is undefined.
inline constexpr std::array kPictureCapabilities = {
    GLenum{GL_CULL_FACE},
    GLenum{GL_DEPTH_TEST},
    GLenum{GL_STENCIL_TEST},
    GLenum{GL_COLOR_LOGIC_OP},
    GLenum{GL_RASTERIZER_DISCARD},
    GLenum{GL_POLYGON_SMOOTH},
    GLenum{GL_SAMPLE_ALPHA_TO_COVERAGE},
    GLenum{GL_SAMPLE_ALPHA_TO_ONE},
    GLenum{GL_SAMPLE_COVERAGE},
    GLenum{GL_SAMPLE_MASK},
    GLenum{GL_SAMPLE_SHADING},
    GLenum{GL_CLIP_DISTANCE0},
    GLenum{GL_CLIP_DISTANCE1},
    GLenum{GL_CLIP_DISTANCE2},
    GLenum{GL_CLIP_DISTANCE3},
    GLenum{GL_CLIP_DISTANCE4},
    GLenum{GL_CLIP_DISTANCE5},
    GLenum{GL_CLIP_DISTANCE6},
    GLenum{GL_CLIP_DISTANCE7},
};

/// Sets everything that decides what becomes of a triangle over the picture in draw buffer 0 of the
/// bound framebuffer, so that it is written there as it is; but for the viewport, the program and
/// the vertex array. Framebuffer sRGB conversion and dithering stay as they are.
void setPictureState(const Functions& gl);

}  // namespace polylume::gl
