// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/frame_check.hpp"

#include <array>

#include "core/text.hpp"
#include "embed/enum_name.hpp"
#include "embed/lighting_programs.hpp"
#include "polylume/error.hpp"

namespace polylume::embed {
namespace {

void checkTexture(const gl::Functions& gl, GLuint texture, const char* what) {
    if (texture == 0) {
        throw Error(concat("expected the name of a texture in ", what, ", found 0"));
    }
    if (gl.IsTexture(texture) == GL_FALSE) {
        throw Error(concat("expected the name of a texture in ", what, ", found ", texture,
                           ", which is none in the current context"));
    }
    // Mesa (22.3) knows GL_TEXTURE_TARGET in the core profile alone, and an error of OpenGL's is
    // what asking must not cause: hosts of the compatibility profile are trusted.
    GLint profile = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if ((profile & GL_CONTEXT_CORE_PROFILE_BIT) == 0) return;
    GLint target = 0;
    gl.GetTextureParameteriv(texture, GL_TEXTURE_TARGET, &target);
    if (target != GL_TEXTURE_2D) {
        throw Error(concat("expected a GL_TEXTURE_2D in ", what, ", found texture ", texture,
                           " of ", enumName(static_cast<GLenum>(target))));
    }
}

glm::ivec2 sizeOf(const gl::Functions& gl, GLuint texture) {
    glm::ivec2 size(0);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &size.x);
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &size.y);
    return size;
}

void checkSize(glm::ivec2 size, glm::ivec2 least, const char* what) {
    if (size.x >= least.x && size.y >= least.y) return;
    throw Error(concat("expected ", what, " to have the ", least.x, "x", least.y,
                       " pixels of LightingFrame::size or more, found ", size.x, "x", size.y));
}

/// Octahedral normals go from -1 to 1.
void checkNormal(const gl::Functions& gl, GLuint texture) {
    const char* what = "GBufferTextureNames::normal";
    checkColorTexture(gl, texture, what);
    GLint type = 0;
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_RED_TYPE, &type);
    if (type == GL_FLOAT || type == GL_SIGNED_NORMALIZED) return;
    GLint format = 0;
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    throw Error(concat("expected ", what,
                       " to have a format that holds -1 to 1, of floats or GL_*_SNORM, found ",
                       "texture ", texture, " of ", enumName(static_cast<GLenum>(format)),
                       "; normals in other forms are read by AreaLightingOptions::surfaceGlsl"));
}

void checkIsNotTarget(const LightingFrame& frame, GLuint texture, const char* what) {
    if (texture != frame.target.texture || texture == 0) return;
    throw Error(concat("expected LightingTarget::texture to be none of the G-buffer's, found ",
                       texture, " for ", what, ", too; add to a texture of its own"));
}

bool isInteger(GLint componentType) {
    return componentType == GL_INT || componentType == GL_UNSIGNED_INT;
}

}  // namespace

void checkColorTexture(const gl::Functions& gl, GLuint texture, const char* what) {
    checkTexture(gl, texture, what);
    GLint type = 0;
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_RED_TYPE, &type);
    if (type != GL_NONE && !isInteger(type)) return;
    throw Error(concat("expected ", what,
                       " to have a format of floats or normalised numbers, "
                       "found texture ",
                       texture, " of ", type == GL_NONE ? "none with red" : "integers"));
}

GLenum checkTarget(const gl::Functions& gl, const LightingFrame& frame, LightingStage stage) {
    if (frame.size.x < 1 || frame.size.y < 1) {
        throw Error(concat("expected LightingFrame::size to be 1x1 or more, found ", frame.size.x,
                           "x", frame.size.y));
    }
    const GLuint texture = frame.target.texture;
    if (texture != 0 && frame.target.framebuffer != 0) {
        throw Error(
            concat("expected one of LightingTarget::texture and LightingTarget::framebuffer, found "
                   "both, ",
                   texture, " and ", frame.target.framebuffer, ": set the other to 0"));
    }
    if (texture == 0) {
        if (stage == LightingStage::compute) {
            throw Error(
                "expected LightingTarget::texture for the compute stage, found 0: it can't "
                "write to a framebuffer");
        }
        const GLuint framebuffer = frame.target.framebuffer;
        if (framebuffer != 0 && gl.IsFramebuffer(framebuffer) == GL_FALSE) {
            throw Error(
                concat("expected the name of a framebuffer in LightingTarget::framebuffer, "
                       "found ",
                       framebuffer, ", which is none in the current context"));
        }
        return 0;
    }
    checkColorTexture(gl, texture, "LightingTarget::texture");
    checkSize(sizeOf(gl, texture), frame.size, "LightingTarget::texture");
    GLint format = 0;
    gl.GetTextureLevelParameteriv(texture, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    if (stage == LightingStage::compute &&
        imageFormatName(static_cast<GLenum>(format)) == nullptr) {
        throw Error(concat("expected LightingTarget::texture to be of ", kImageFormats,
                           " for the compute stage, found ", enumName(static_cast<GLenum>(format)),
                           "; the fragment stage draws to all colour formats"));
    }
    return static_cast<GLenum>(format);
}

glm::ivec2 checkGBuffer(const gl::Functions& gl, const LightingFrame& frame, bool withSheen) {
    const GBufferTextureNames& names = frame.gbuffer;
    struct Input {
        GLuint texture;
        const char* what;
    };
    const std::array colors = {
        Input{names.normal, "GBufferTextureNames::normal"},
        Input{names.diffuseRoughness, "GBufferTextureNames::diffuseRoughness"},
        Input{names.specular, "GBufferTextureNames::specular"},
        Input{names.emission, "GBufferTextureNames::emission"},
        Input{names.sheen, "GBufferTextureNames::sheen"},
    };
    const char* depthName = "GBufferTextureNames::depth";
    checkTexture(gl, names.depth, depthName);
    GLint depthType = 0;
    gl.GetTextureLevelParameteriv(names.depth, 0, GL_TEXTURE_DEPTH_TYPE, &depthType);
    if (depthType == GL_NONE) {
        throw Error(concat("expected ", depthName, " to have a depth format, found texture ",
                           names.depth, " without depth"));
    }
    const glm::ivec2 size = sizeOf(gl, names.depth);
    checkSize(size, frame.size, depthName);
    checkNormal(gl, names.normal);
    checkIsNotTarget(frame, names.depth, depthName);
    for (std::size_t i = 0; i < colors.size() - (withSheen ? 0 : 1); ++i) {
        checkColorTexture(gl, colors[i].texture, colors[i].what);
        checkIsNotTarget(frame, colors[i].texture, colors[i].what);
        const glm::ivec2 found = sizeOf(gl, colors[i].texture);
        if (found == size) continue;
        throw Error(concat("expected ", colors[i].what, " to be as large as ", depthName, ", ",
                           size.x, "x", size.y, ", found ", found.x, "x", found.y));
    }
    return size;
}

void checkDrawFramebuffer(const gl::Functions& gl, GLuint name, const char* what) {
    const GLenum status = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(concat("expected ", what,
                           " to be something that the driver draws to, found an incomplete "
                           "framebuffer (",
                           enumName(status), ")"));
    }
    GLint buffer = GL_NONE;
    gl.GetIntegerv(GL_DRAW_BUFFER0, &buffer);
    if (buffer == GL_NONE) {
        throw Error(concat("expected ", what, " to have a draw buffer 0, found none"));
    }
    if (name == 0) return;
    GLint type = 0;
    gl.GetNamedFramebufferAttachmentParameteriv(name, static_cast<GLenum>(buffer),
                                                GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    if (isInteger(type)) {
        throw Error(concat("expected draw buffer 0 of ", what,
                           " to hold floats or normalised numbers, found integers"));
    }
}

}  // namespace polylume::embed
