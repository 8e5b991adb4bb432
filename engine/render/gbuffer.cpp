// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/gbuffer.hpp"

#include "core/text.hpp"

namespace polylume {

GBuffer::GBuffer(const gl::Functions& gl, glm::ivec2 size, bool withSheen) : gl_(gl) {
    std::vector<gl::Framebuffer::Attachment> attachments;
    textures_.reserve(kGBufferAttachments.size());
    for (const GBufferAttachment& attachment : kGBufferAttachments) {
        if (attachment.isForSheen && !withSheen) continue;
        const std::string label = concat("G-buffer, ", attachment.name);
        textures_.emplace_back(gl, attachment.format, size, 1, label.c_str());
        attachments.push_back({attachment.point, &textures_.back()});
    }
    framebuffer_ = gl::Framebuffer(gl, attachments, "G-buffer");
}

void GBuffer::begin() const {
    framebuffer_.bind();
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_SCISSOR_TEST);
    const float zero[4] = {};
    const GLint colorCount = static_cast<GLint>(textures_.size()) - 1;
    for (GLint i = 0; i < colorCount; ++i) {
        gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, i, zero);
    }
    gl_.ClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, zero);
}

std::vector<std::string> GBuffer::defines() const {
    if (hasSheen()) return {"POLYLUME_SHEEN"};
    return {};
}

GBufferTextures GBuffer::textureNames() const {
    GBufferTextures names{};
    for (std::size_t i = 0; i < textures_.size(); ++i) names[i] = textures_[i].name();
    return names;
}

}  // namespace polylume
