// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "gl/functions.hpp"
#include "gl/picture_state.hpp"

// Parts of a host's OpenGL state, each read when its keeper is made and given back at its end, also
// by an exception. None allocates, reads or causes an OpenGL error.
namespace polylume::embed {

/// How pixels are read from the host's memory. In between it is as OpenGL has it at first.
class UnpackKeeper {
  public:
    explicit UnpackKeeper(const gl::Functions& gl);
    ~UnpackKeeper();
    UnpackKeeper(const UnpackKeeper&) = delete;
    UnpackKeeper& operator=(const UnpackKeeper&) = delete;

  private:
    static constexpr std::size_t kParameterCount = 8;

    const gl::Functions& gl_;
    std::array<GLint, kParameterCount> values_{};
    GLint buffer_ = 0;
};

/// The query buffer, which would take results of queries. In between none is bound.
class QueryBufferKeeper {
  public:
    explicit QueryBufferKeeper(const gl::Functions& gl);
    ~QueryBufferKeeper();
    QueryBufferKeeper(const QueryBufferKeeper&) = delete;
    QueryBufferKeeper& operator=(const QueryBufferKeeper&) = delete;

  private:
    const gl::Functions& gl_;
    GLint buffer_ = 0;
};

/// The program and what it reads by. In between transform feedback is paused.
class ShaderInputKeeper {
  public:
    /// Of a texture unit that changes its texture of `target` and its sampler.
    struct Unit {
        GLuint unit;
        GLenum target;  ///< GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY or GL_TEXTURE_BUFFER.
    };
    /// Of an indexed buffer binding.
    struct Block {
        GLenum target;  ///< GL_UNIFORM_BUFFER or GL_SHADER_STORAGE_BUFFER.
        GLuint binding;
    };
    static constexpr std::size_t kMostUnits = 16;
    static constexpr std::size_t kMostBlocks = 16;

    /// The lists have at most kMostUnits and kMostBlocks, and live on.
    ShaderInputKeeper(const gl::Functions& gl, std::span<const Unit> units,
                      std::span<const Block> blocks);
    ~ShaderInputKeeper();
    ShaderInputKeeper(const ShaderInputKeeper&) = delete;
    ShaderInputKeeper& operator=(const ShaderInputKeeper&) = delete;

  private:
    struct BufferRange {
        GLint name = 0;
        GLint64 start = 0;
        GLint64 size = 0;
    };

    void keepUnits();
    void restoreUnits() const;
    void keepBlocks();
    void restoreBlocks() const;

    const gl::Functions& gl_;
    std::span<const Unit> units_;
    std::span<const Block> blocks_;
    GLint program_ = 0;
    bool isFeedbackPaused_ = false;  ///< By us.
    GLint activeTexture_ = GL_TEXTURE0;
    std::array<GLint, kMostUnits> textures_{};
    std::array<GLint, kMostUnits> samplers_{};
    std::array<BufferRange, kMostBlocks> buffers_{};
};

/// Image unit 0.
class ImageUnitKeeper {
  public:
    explicit ImageUnitKeeper(const gl::Functions& gl);
    ~ImageUnitKeeper();
    ImageUnitKeeper(const ImageUnitKeeper&) = delete;
    ImageUnitKeeper& operator=(const ImageUnitKeeper&) = delete;

  private:
    const gl::Functions& gl_;
    GLint name_ = 0, level_ = 0, layer_ = 0, access_ = GL_READ_ONLY, format_ = GL_R8;
    GLboolean isLayered_ = GL_FALSE;
};

/// What decides where a triangle over the picture goes and what becomes of it: vertex array, draw
/// framebuffer, viewport 0, all that gl::setPictureState() sets, blending of draw buffer 0, colour
/// masks of all. In between what a compatibility profile has beside is off.
class PictureKeeper {
  public:
    static constexpr int kMostDrawBuffers = 32;

    /// What a context has, for all keepers in it.
    struct Traits {
        int drawBufferCount = 1;
        bool isCompatibility = false;  ///< The profile.

        static Traits of(const gl::Functions& gl);
    };

    PictureKeeper(const gl::Functions& gl, const Traits& traits);
    ~PictureKeeper();
    PictureKeeper(const PictureKeeper&) = delete;
    PictureKeeper& operator=(const PictureKeeper&) = delete;

  private:
    /// The compatibility profile's: off in between.
    void keepOldCapabilities();
    void restoreOldCapabilities() const;

    const gl::Functions& gl_;
    Traits traits_;
    GLint vertexArray_ = 0;
    GLint framebuffer_ = 0;
    std::array<GLfloat, 4> viewport_{};
    std::array<GLboolean, gl::kPictureCapabilities.size()> capabilities_{};
    GLboolean scissor_ = GL_FALSE;
    GLboolean blend_ = GL_FALSE;
    std::array<GLint, 4> blendFactors_{};    ///< Source and destination of colour, and of alpha.
    std::array<GLint, 2> blendEquations_{};  ///< Of colour, and of alpha.
    std::array<std::array<GLboolean, 4>, kMostDrawBuffers> colorMasks_{};
    std::array<GLint, 2> polygonMode_{GL_FILL, GL_FILL};  ///< Front, back.
    GLboolean alphaTest_ = GL_FALSE;
    GLboolean polygonStipple_ = GL_FALSE;
    GLint clampFragmentColor_ = GL_FIXED_ONLY;
};

}  // namespace polylume::embed
