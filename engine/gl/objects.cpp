// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/objects.hpp"

#include <algorithm>
#include <vector>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::gl {
namespace {

template <typename Create>
GLuint createName(Create create) {
    GLuint name = 0;
    create(1, &name);
    return name;
}

const char* describeStatus(GLenum status) {
    switch (status) {
        case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
            return "an attachment is incomplete, as when there is too little memory for its size";
        case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
            return "it has no attachment";
        case GL_FRAMEBUFFER_UNSUPPORTED:
            return "the driver does not support this combination of formats";
        case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
            return "the attachments differ in their number of samples";
        default:
            return "unknown status";
    }
}

}  // namespace

Buffer::Buffer(const Functions& gl, std::size_t sizeBytes, const std::byte* bytes, GLbitfield flags,
               const char* label)
    : handle_(gl, createName(gl.CreateBuffers)), sizeBytes_(std::max<std::size_t>(sizeBytes, 1)) {
    gl.NamedBufferStorage(name(), static_cast<GLsizeiptr>(sizeBytes_), bytes, flags);
    gl.ObjectLabel(GL_BUFFER, name(), -1, label);
}

Buffer::Buffer(const Functions& gl, std::span<const std::byte> bytes, GLbitfield flags,
               const char* label)
    : Buffer(gl, bytes.size(), bytes.empty() ? nullptr : bytes.data(), flags, label) {}

Buffer Buffer::ofSize(const Functions& gl, std::size_t sizeBytes, GLbitfield flags,
                      const char* label) {
    return {gl, sizeBytes, nullptr, flags, label};
}

void Buffer::update(std::span<const std::byte> bytes, std::size_t offset) {
    if (bytes.empty()) return;
    handle_.functions().NamedBufferSubData(name(), static_cast<GLintptr>(offset),
                                           static_cast<GLsizeiptr>(bytes.size()), bytes.data());
}

Texture::Texture(const Functions& gl, GLenum target, glm::ivec2 size, const char* label)
    : handle_(gl, createName([&](GLsizei count, GLuint* names) {
                  gl.CreateTextures(target, count, names);
              })),
      size_(size) {
    gl.ObjectLabel(GL_TEXTURE, name(), -1, label);
    // Render targets and tables are read texel by texel; material textures get a sampler object.
    setParameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    setParameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    setParameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    setParameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Texture::Texture(const Functions& gl, GLenum format, glm::ivec2 size, int levelCount,
                 const char* label)
    : Texture(gl, GL_TEXTURE_2D, size, label) {
    gl.TextureStorage2D(name(), levelCount, format, size.x, size.y);
}

Texture Texture::array(const Functions& gl, GLenum format, glm::ivec2 size, int layerCount,
                       const char* label) {
    Texture texture(gl, GL_TEXTURE_2D_ARRAY, size, label);
    texture.layerCount_ = layerCount;
    gl.TextureStorage3D(texture.name(), 1, format, size.x, size.y, layerCount);
    return texture;
}

BufferTexture::BufferTexture(const Functions& gl, GLenum format, const Buffer& buffer,
                             const char* label)
    : handle_(gl, createName([&](GLsizei count, GLuint* names) {
                  gl.CreateTextures(GL_TEXTURE_BUFFER, count, names);
              })) {
    gl.ObjectLabel(GL_TEXTURE, name(), -1, label);
    gl.TextureBuffer(name(), format, buffer.name());
}

void Texture::upload(GLenum format, GLenum type, const void* pixels) {
    if (layerCount_ == 0) return uploadLevel(0, format, type, pixels);
    const Functions& gl = handle_.functions();
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TextureSubImage3D(name(), 0, 0, 0, 0, size_.x, size_.y, layerCount_, format, type, pixels);
}

void Texture::uploadLevel(int level, GLenum format, GLenum type, const void* pixels) {
    const Functions& gl = handle_.functions();
    const glm::ivec2 size = glm::max(size_ >> level, glm::ivec2(1));
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TextureSubImage2D(name(), level, 0, 0, size.x, size.y, format, type, pixels);
}

void Texture::setParameter(GLenum parameter, GLint value) {
    handle_.functions().TextureParameteri(name(), parameter, value);
}

void Texture::read(GLenum format, GLenum type, std::span<std::byte> pixels) const {
    const Functions& gl = handle_.functions();
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.GetTextureImage(name(), 0, format, type, static_cast<GLsizei>(pixels.size()), pixels.data());
}

SamplerObject::SamplerObject(const Functions& gl, GLenum magFilter, GLenum minFilter, GLenum wrapS,
                             GLenum wrapT)
    : handle_(gl, createName(gl.CreateSamplers)) {
    gl.SamplerParameteri(name(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magFilter));
    gl.SamplerParameteri(name(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minFilter));
    gl.SamplerParameteri(name(), GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapS));
    gl.SamplerParameteri(name(), GL_TEXTURE_WRAP_T, static_cast<GLint>(wrapT));
}

Framebuffer::Framebuffer(const Functions& gl, std::span<const Attachment> attachments,
                         const char* label)
    : handle_(gl, createName(gl.CreateFramebuffers)) {
    std::vector<GLenum> drawBuffers;
    for (const Attachment& attachment : attachments) {
        gl.NamedFramebufferTexture(name(), attachment.point, attachment.texture->name(), 0);
        size_ = attachment.texture->size();
        if (attachment.point != GL_DEPTH_ATTACHMENT) drawBuffers.push_back(attachment.point);
    }
    gl.NamedFramebufferDrawBuffers(name(), static_cast<GLsizei>(drawBuffers.size()),
                                   drawBuffers.data());
    gl.ObjectLabel(GL_FRAMEBUFFER, name(), -1, label);
    const GLenum status = gl.CheckNamedFramebufferStatus(name(), GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error(concat("framebuffer \"", label, "\" of ", size_.x, "x", size_.y,
                           " pixels is incomplete: ", describeStatus(status), " (0x", std::hex,
                           status, ")"));
    }
}

void Framebuffer::bind() const {
    const Functions& gl = handle_.functions();
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name());
    gl.Viewport(0, 0, size_.x, size_.y);
}

VertexArray::VertexArray(const Functions& gl, const char* label)
    : handle_(gl, createName(gl.CreateVertexArrays)) {
    gl.ObjectLabel(GL_VERTEX_ARRAY, name(), -1, label);
}

void VertexArray::setFloats(GLuint location, int componentCount, const Buffer& buffer, int stride) {
    const Functions& gl = handle_.functions();
    gl.VertexArrayVertexBuffer(name(), location, buffer.name(), 0, stride);
    gl.EnableVertexArrayAttrib(name(), location);
    gl.VertexArrayAttribFormat(name(), location, componentCount, GL_FLOAT, GL_FALSE, 0);
    gl.VertexArrayAttribBinding(name(), location, location);
}

void VertexArray::setIndices(const Buffer& buffer) {
    handle_.functions().VertexArrayElementBuffer(name(), buffer.name());
}

}  // namespace polylume::gl
