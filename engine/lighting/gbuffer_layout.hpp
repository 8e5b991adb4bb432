// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstddef>

#include "gl/functions.hpp"

namespace polylume {

/// One texture of the G-buffer.
struct GBufferAttachment {
    const char* name;
    const char* meaning;
    GLenum format;
    GLenum point;
    /// There only where a scene has sheen; the shaders' variant POLYLUME_SHEEN writes and reads it.
    bool isForSheen = false;
};

/// The G-buffer. From this table come the textures, the framebuffer and the units that the lighting
/// pass reads (an attachment's index is its unit); glsl/surface/gbuffer_write.glsl and
/// gbuffer_read.glsl follow it.
///
/// Nothing is stored with so few bits that a mirror shows them: normals are float, the position
/// comes from a reversed float depth, and roughness and colours have 16 bits.
inline constexpr std::array kGBufferAttachments = {
    GBufferAttachment{"normal", "shading normal, octahedral, world space", GL_RG32F,
                      GL_COLOR_ATTACHMENT0},
    GBufferAttachment{"diffuseRoughness",
                      "RGB: base colour * (1 - metallic), A: perceptual roughness", GL_RGBA16,
                      GL_COLOR_ATTACHMENT1},
    GBufferAttachment{"specular", "RGB: F0, A: F90", GL_RGBA16, GL_COLOR_ATTACHMENT2},
    GBufferAttachment{"emission", "RGB: emitted radiance in nits, A: occlusion", GL_RGBA32F,
                      GL_COLOR_ATTACHMENT3},
    GBufferAttachment{"depth", "1 near, 0 far and background", GL_DEPTH_COMPONENT32F,
                      GL_DEPTH_ATTACHMENT},
    GBufferAttachment{"sheen", "RGB: sheen colour, A: sheen roughness, perceptual", GL_RGBA16,
                      GL_COLOR_ATTACHMENT4, true},
};

/// Places in kGBufferAttachments.
inline constexpr std::size_t kDepthAttachment = 4;
inline constexpr std::size_t kSheenAttachment = 5;

/// The texture names in the order of kGBufferAttachments; 0 for one that is left out.
using GBufferTextures = std::array<GLuint, kGBufferAttachments.size()>;

}  // namespace polylume
