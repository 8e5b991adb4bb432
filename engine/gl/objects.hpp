// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string_view>

#include "gl/handle.hpp"

// Small owners of OpenGL objects. All need their context current; `label` names the object in debug
// messages and in a debugger.
namespace polylume::gl {

/// Immutable storage of a fixed size.
class Buffer {
  public:
    Buffer() = default;
    /// Holds a copy of `bytes`; `flags` as glNamedBufferStorage takes them. At least one byte is
    /// allocated, so that an empty list can be bound.
    Buffer(const Functions& gl, std::span<const std::byte> bytes, GLbitfield flags,
           const char* label);

    /// One that holds nothing in particular.
    static Buffer ofSize(const Functions& gl, std::size_t sizeBytes, GLbitfield flags,
                         const char* label);

    /// Replaces the bytes from `offset` on; the buffer was made with GL_DYNAMIC_STORAGE_BIT.
    void update(std::span<const std::byte> bytes, std::size_t offset = 0);

    GLuint name() const { return handle_.name(); }
    std::size_t sizeBytes() const { return sizeBytes_; }

  private:
    Buffer(const Functions& gl, std::size_t sizeBytes, const std::byte* bytes, GLbitfield flags,
           const char* label);

    static void destroy(const Functions& gl, GLuint name) { gl.DeleteBuffers(1, &name); }
    Handle<&Buffer::destroy> handle_;
    std::size_t sizeBytes_ = 0;
};

/// The bytes of a value or of a contiguous range, for Buffer.
template <typename T>
std::span<const std::byte> bytesOf(const T& value) {
    if constexpr (requires { std::span(value); }) {
        return std::as_bytes(std::span(value));
    } else {
        return std::as_bytes(std::span(&value, 1));
    }
}

/// A 2D texture of immutable storage, or an array of such.
class Texture {
  public:
    Texture() = default;
    Texture(const Functions& gl, GLenum format, glm::ivec2 size, int levelCount, const char* label);

    /// An array of `layerCount` layers (GL_TEXTURE_2D_ARRAY) with one level each.
    static Texture array(const Functions& gl, GLenum format, glm::ivec2 size, int layerCount,
                         const char* label);

    /// Fills level 0 from rows without padding, of an array layer after layer.
    void upload(GLenum format, GLenum type, const void* pixels);
    /// Fills `level` of what is no array.
    void uploadLevel(int level, GLenum format, GLenum type, const void* pixels);
    void setParameter(GLenum parameter, GLint value);
    /// Reads level 0 into `pixels`, rows from the bottom, without padding.
    void read(GLenum format, GLenum type, std::span<std::byte> pixels) const;

    GLuint name() const { return handle_.name(); }
    glm::ivec2 size() const { return size_; }

  private:
    static void destroy(const Functions& gl, GLuint name) { gl.DeleteTextures(1, &name); }
    /// A texture without storage.
    Texture(const Functions& gl, GLenum target, glm::ivec2 size, const char* label);

    Handle<&Texture::destroy> handle_;
    glm::ivec2 size_{0};
    int layerCount_ = 0;  ///< 0 where it is no array.
};

/// A buffer's contents as texels (GL_TEXTURE_BUFFER). The buffer outlives it.
class BufferTexture {
  public:
    BufferTexture() = default;
    BufferTexture(const Functions& gl, GLenum format, const Buffer& buffer, const char* label);
    GLuint name() const { return handle_.name(); }

  private:
    static void destroy(const Functions& gl, GLuint name) { gl.DeleteTextures(1, &name); }
    Handle<&BufferTexture::destroy> handle_;
};

/// How a texture is filtered and wrapped.
class SamplerObject {
  public:
    SamplerObject() = default;
    SamplerObject(const Functions& gl, GLenum magFilter, GLenum minFilter, GLenum wrapS,
                  GLenum wrapT);
    GLuint name() const { return handle_.name(); }

  private:
    static void destroy(const Functions& gl, GLuint name) { gl.DeleteSamplers(1, &name); }
    Handle<&SamplerObject::destroy> handle_;
};

/// Draws into textures, which it does not own and which outlive it.
class Framebuffer {
  public:
    struct Attachment {
        GLenum point = GL_COLOR_ATTACHMENT0;  ///< Or GL_DEPTH_ATTACHMENT.
        const Texture* texture = nullptr;
    };

    Framebuffer() = default;
    /// Throws Error that names `label` and the reason when the result is incomplete.
    Framebuffer(const Functions& gl, std::span<const Attachment> attachments, const char* label);

    /// Binds it for drawing, with a viewport over all of it.
    void bind() const;

    GLuint name() const { return handle_.name(); }
    glm::ivec2 size() const { return size_; }

  private:
    static void destroy(const Functions& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }
    Handle<&Framebuffer::destroy> handle_;
    glm::ivec2 size_{0};
};

/// The layout of vertex attributes.
class VertexArray {
  public:
    VertexArray() = default;
    VertexArray(const Functions& gl, const char* label);

    /// Feeds attribute `location` with `componentCount` floats a vertex, `stride` bytes apart, of
    /// `buffer`.
    void setFloats(GLuint location, int componentCount, const Buffer& buffer, int stride);
    void setIndices(const Buffer& buffer);

    GLuint name() const { return handle_.name(); }

  private:
    static void destroy(const Functions& gl, GLuint name) { gl.DeleteVertexArrays(1, &name); }
    Handle<&VertexArray::destroy> handle_;
};

}  // namespace polylume::gl
