// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "bench/bench_lights.hpp"
#include "render/frame_renderer.hpp"

namespace polylume::bench {

/// The floor of makeFloorScene() in a G-buffer, and a picture to light it into.
class LitFloor {
  public:
    LitFloor(const gl::Functions& gl, const gl::ShaderLibrary& library, Model model,
             glm::ivec2 size);

    /// Lights every pixel by `pass`.
    void light(LightingPass& pass) const;

    const GBuffer& gbuffer() const { return renderer_.gbuffer(); }
    const shared::CameraData& cameraData() const { return renderer_.cameraData(); }
    const gl::Texture& radiance() const { return radiance_; }

  private:
    scene::Scene scene_;
    FrameRenderer renderer_;
    gl::Texture radiance_;
    gl::Framebuffer target_;  ///< Over `radiance_` and the G-buffer's depth.
};

}  // namespace polylume::bench
