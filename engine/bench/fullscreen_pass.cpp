// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/fullscreen_pass.hpp"

#include "gl/picture_state.hpp"

namespace polylume::bench {
namespace {

gl::Framebuffer makeFramebuffer(const gl::Functions& gl, const gl::Texture& target) {
    const gl::Framebuffer::Attachment attachment{GL_COLOR_ATTACHMENT0, &target};
    return {gl, std::span(&attachment, 1), "benchmark"};
}

}  // namespace

FullscreenPass::FullscreenPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                               std::string_view fragmentPath, std::span<const std::string> defines,
                               glm::ivec2 size)
    : gl_(&gl),
      program_(gl, library, "passes/fullscreen.vert", fragmentPath, defines, "benchmark"),
      target_(gl, GL_RGBA32F, size, 1, "benchmark"),
      framebuffer_(makeFramebuffer(gl, target_)),
      noVertices_(gl, "benchmark, no vertices") {}

void FullscreenPass::draw() const {
    framebuffer_.bind();
    gl::setPictureState(*gl_);
    program_.use();
    gl_->BindVertexArray(noVertices_.name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace polylume::bench
