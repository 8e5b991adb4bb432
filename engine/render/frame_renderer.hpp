// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "context/context.hpp"
#include "render/blend_pass.hpp"
#include "render/emitter_pass.hpp"
#include "render/gbuffer.hpp"
#include "render/geometry_pass.hpp"
#include "render/gpu_scene.hpp"
#include "render/renderer.hpp"
#include "shared/camera_data.h"

namespace polylume {

/// Everything that one picture needs on the GPU, and its passes in their order.
class FrameRenderer {
  public:
    /// Keeps references to all but `options`.
    FrameRenderer(const gl::Functions& gl, const gl::ShaderLibrary& library,
                  const scene::Scene& scene, const scene::Camera& camera,
                  const RenderOptions& options);

    /// Draws one frame whose pixels are sampled at `samplePosition`: G-buffer, lighting,
    /// transparent surfaces.
    void drawFrame(glm::dvec2 samplePosition);
    /// The first part of that alone.
    void drawGBuffer(glm::dvec2 samplePosition);
    /// Adds the last frame to the sum.
    void accumulate();
    /// The sum's mean over `frameCount` frames: R, G, B, A, rows from the top.
    FloatImage readMean(int frameCount) const;

    const GBuffer& gbuffer() const { return gbuffer_; }
    const shared::CameraData& cameraData() const { return cameraData_; }
    LightingPass& lighting() { return lighting_; }

  private:
    const gl::Functions& gl_;
    const scene::Camera& camera_;
    RenderOptions options_;
    LightingPass lighting_;
    GpuScene gpuScene_;
    GBuffer gbuffer_;
    gl::Texture radiance_;
    gl::Texture sum_;
    gl::Framebuffer frameTarget_;
    gl::Framebuffer sumTarget_;
    gl::Program accumulateProgram_;
    gl::VertexArray noVertices_;
    shared::CameraData cameraData_{};  ///< Before the block, which is made from it.
    gl::Buffer cameraBlock_;
    GeometryPass geometry_;
    EmitterPass emitters_;
    BlendPass blend_;
};

}  // namespace polylume
