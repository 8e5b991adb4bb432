// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "bench/lit_floor.hpp"

#include <array>

namespace polylume::bench {
namespace {

RenderOptions makeOptions(Model model, glm::ivec2 size) {
    RenderOptions options;
    options.size = size;
    options.hideLights = true;
    options.model = lightingModel(model);
    return options;
}

gl::Framebuffer makeTarget(const gl::Functions& gl, const gl::Texture& color,
                           const gl::Texture& depth) {
    const std::array attachments = {gl::Framebuffer::Attachment{GL_COLOR_ATTACHMENT0, &color},
                                    gl::Framebuffer::Attachment{GL_DEPTH_ATTACHMENT, &depth}};
    return {gl, attachments, "lit floor"};
}

}  // namespace

LitFloor::LitFloor(const gl::Functions& gl, const gl::ShaderLibrary& library, Model model,
                   glm::ivec2 size)
    : scene_(makeFloorScene(model)),
      renderer_(gl, library, scene_, makeFloorCamera(), makeOptions(model, size)),
      radiance_(gl, GL_RGBA32F, size, 1, "lit floor"),
      target_(makeTarget(gl, radiance_, renderer_.gbuffer().depth())) {
    renderer_.drawGBuffer({0.5, 0.5});
    const std::array black = {0.0f, 0.0f, 0.0f, 0.0f};
    gl.ClearNamedFramebufferfv(target_.name(), GL_COLOR, 0, black.data());
}

void LitFloor::light(LightingPass& pass) const {
    target_.bind();
    pass.draw(renderer_.gbuffer().textureNames());
}

}  // namespace polylume::bench
