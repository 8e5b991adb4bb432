// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "lighting/gbuffer_layout.hpp"

namespace polylume {

/// The textures of kGBufferAttachments and the framebuffer over them.
class GBuffer {
  public:
    /// The attachment for sheen is made where `withSheen`.
    GBuffer(const gl::Functions& gl, glm::ivec2 size, bool withSheen = false);

    /// Binds it for drawing and clears it to the background.
    void begin() const;

    GBufferTextures textureNames() const;
    bool hasSheen() const { return textures_.size() > kSheenAttachment; }
    /// The defines of the shaders that write it.
    std::vector<std::string> defines() const;
    /// In the order of kGBufferAttachments.
    const gl::Texture& texture(std::size_t index) const { return textures_[index]; }
    gl::Texture& texture(std::size_t index) { return textures_[index]; }
    const gl::Texture& depth() const { return textures_[kDepthAttachment]; }
    glm::ivec2 size() const { return framebuffer_.size(); }

  private:
    const gl::Functions& gl_;
    std::vector<gl::Texture> textures_;
    gl::Framebuffer framebuffer_;
};

}  // namespace polylume
