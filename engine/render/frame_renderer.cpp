// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "render/frame_renderer.hpp"

#include <algorithm>
#include <array>

#include "view/camera_projection.hpp"
#include "view/scene_lights.hpp"

namespace polylume {
namespace {

LightingPass makeLighting(const gl::Functions& gl, const gl::ShaderLibrary& library,
                          const scene::Scene& scene, const RenderOptions& options) {
    LightingModel model = options.model;
    model.sheen = scene.hasSheen();
    LightingPass lighting = options.specularTable
                                ? LightingPass(gl, library, *options.specularTable, model)
                                : LightingPass(gl, library, model);
    lighting.setLights(lightsOf(scene, options));
    lighting.setLobes(options.lobes);
    return lighting;
}

gl::Framebuffer makeTarget(const gl::Functions& gl, const gl::Texture& color,
                           const gl::Texture* depth, const char* label) {
    std::vector<gl::Framebuffer::Attachment> attachments = {{GL_COLOR_ATTACHMENT0, &color}};
    if (depth != nullptr) attachments.push_back({GL_DEPTH_ATTACHMENT, depth});
    return {gl, attachments, label};
}

}  // namespace

FrameRenderer::FrameRenderer(const gl::Functions& gl, const gl::ShaderLibrary& library,
                             const scene::Scene& scene, const scene::Camera& camera,
                             const RenderOptions& options)
    : gl_(gl),
      camera_(camera),
      options_(options),
      lighting_(makeLighting(gl, library, scene, options)),
      gpuScene_(gl, scene),
      gbuffer_(gl, options.size, lighting_.model().sheen),
      radiance_(gl, GL_RGBA32F, options.size, 1, "radiance of a frame"),
      sum_(gl, GL_RGBA32F, options.size, 1, "sum of frames"),
      frameTarget_(makeTarget(gl, radiance_, &gbuffer_.depth(), "frame")),
      sumTarget_(makeTarget(gl, sum_, nullptr, "sum")),
      accumulateProgram_(gl, library, "passes/fullscreen.vert", "passes/accumulate.frag", {},
                         "accumulate"),
      noVertices_(gl, "no vertices"),
      cameraBlock_(gl, gl::bytesOf(cameraData_), GL_DYNAMIC_STORAGE_BIT, "camera"),
      geometry_(gl, library, gpuScene_, gbuffer_),
      emitters_(gl, library, lighting_),
      blend_(gl, library, gpuScene_, lighting_, camera) {
    const float zero[4] = {};
    gl_.ClearNamedFramebufferfv(sumTarget_.name(), GL_COLOR, 0, zero);
}

void FrameRenderer::drawGBuffer(glm::dvec2 samplePosition) {
    cameraData_ = makeCameraData(camera_, options_.size, samplePosition);
    cameraBlock_.update(gl::bytesOf(cameraData_));
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, shared::kCameraBinding, cameraBlock_.name());

    gbuffer_.begin();
    geometry_.draw();
    if (!options_.hideLights) emitters_.draw();
}

void FrameRenderer::drawFrame(glm::dvec2 samplePosition) {
    drawGBuffer(samplePosition);
    frameTarget_.bind();
    const glm::vec4 background =
        options_.background ? glm::vec4(*options_.background, 1.0f) : glm::vec4(0.0f);
    gl_.ClearNamedFramebufferfv(frameTarget_.name(), GL_COLOR, 0, &background[0]);
    lighting_.draw(gbuffer_.textureNames());
    blend_.draw();
}

void FrameRenderer::accumulate() {
    sumTarget_.bind();
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFunc(GL_ONE, GL_ONE);
    accumulateProgram_.use();
    gl_.BindTextureUnit(0, radiance_.name());
    gl_.BindSampler(0, 0);
    gl_.BindVertexArray(noVertices_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

FloatImage FrameRenderer::readMean(int frameCount) const {
    FloatImage image;
    image.width = options_.size.x;
    image.height = options_.size.y;
    image.channelNames = {"R", "G", "B", "A"};
    const std::size_t rowLength = static_cast<std::size_t>(image.width) * 4;
    image.pixels.resize(rowLength * image.height);
    sum_.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(image.pixels)));
    for (int y = 0; y < image.height / 2; ++y) {
        std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + rowLength,
                         image.pixel(0, image.height - 1 - y));
    }
    for (float& value : image.pixels) value /= static_cast<float>(frameCount);
    return image;
}

}  // namespace polylume
