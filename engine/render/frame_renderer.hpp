// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>

#include "render/blend_pass.hpp"
#include "render/emitter_pass.hpp"
#include "render/gbuffer.hpp"
#include "render/geometry_pass.hpp"
#include "render/gpu_scene.hpp"
#include "render/pass_clock.hpp"
#include "render/renderer.hpp"
#include "shared/camera_data.h"

namespace polylume {

/// Everything that pictures of one scene need on the GPU, and their passes in their order. Camera,
/// size, lights and all else but the scene's shapes can change from frame to frame.
class FrameRenderer {
  public:
    /// Keeps references to the first three.
    FrameRenderer(const gl::Functions& gl, const gl::ShaderLibrary& library,
                  const scene::Scene& scene, const scene::Camera& camera,
                  const RenderOptions& options);

    void setCamera(const scene::Camera& camera);
    /// Clears the sum.
    void setSize(glm::ivec2 size);
    /// Puts `lights` in place of the scene's and those of the options. Throws Error as
    /// LightingPass::setLights() does, and leaves the old ones.
    void setLights(const LightSet& lights);
    void setLobes(Lobes lobes);
    /// As LightingPass has it.
    void setLightThreshold(std::optional<float> nits);
    /// The stated threshold, or the one that RenderOptions::chooseLightThreshold gives, which draws
    /// a small picture; none where all lights count.
    std::optional<float> findLightThreshold();
    /// Takes that one, if there are enough lights for it to matter.
    void chooseLightThreshold();
    /// Whether it has sheen follows the scene. Throws ShaderError, and leaves the old one.
    void setModel(const LightingModel& model);
    void setBackground(const std::optional<glm::vec3>& background);
    void setHideLights(bool hideLights);
    /// Takes over materials of the scene that were changed, and textures that were added.
    void updateMaterials();
    /// Times the passes "geometry", "emitters", "lighting" and "transparent"; null: none.
    void setClock(PassClock* clock) { clock_ = clock; }

    /// Draws one frame whose pixels are sampled at `samplePosition`: G-buffer, lighting,
    /// transparent surfaces.
    void drawFrame(glm::dvec2 samplePosition);
    /// The first part of that alone.
    void drawGBuffer(glm::dvec2 samplePosition);
    /// Adds the last frame to the sum. The first one is the sum, without a pass.
    void accumulate();
    void clearSum();
    /// The sum's mean over `frameCount` frames: R, G, B, A, rows from the top.
    FloatImage readMean(int frameCount) const;

    /// The sum of frames, rows from the bottom, until the next frame or accumulate(). Undefined
    /// where none has been added.
    const gl::Texture& sum() const {
        return sumPlace_ == SumPlace::texture ? targets_->sum : targets_->radiance;
    }
    const GBuffer& gbuffer() const { return targets_->gbuffer; }
    const shared::CameraData& cameraData() const { return cameraData_; }
    glm::ivec2 size() const { return options_.size; }
    LightingPass& lighting() { return *lighting_; }
    const LightingPass& lighting() const { return *lighting_; }

  private:
    double logMeanAtASmallSize();

    /// What depends on the picture's size.
    struct Targets {
        GBuffer gbuffer;
        gl::Texture radiance;
        gl::Framebuffer frame;      ///< Over `radiance` and the G-buffer's depth.
        gl::Texture sum;            ///< Of two frames or more; made by the second one.
        gl::Framebuffer sumTarget;  ///< Over `sum`.

        Targets(const gl::Functions& gl, glm::ivec2 size, bool withSheen);
    };

    /// Where the sum of frames is: nowhere, as it is zero; where the one frame was drawn; or in its
    /// own texture.
    enum class SumPlace { none, frame, texture };

    /// Takes the sum out of the frame's texture, where it is there.
    void moveSum();

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    scene::Camera camera_;
    RenderOptions options_;
    LightSet lights_;
    std::unique_ptr<LightingPass> lighting_;
    GpuScene gpuScene_;
    std::unique_ptr<Targets> targets_;
    SumPlace sumPlace_ = SumPlace::none;
    gl::Program accumulateProgram_;  ///< Made by the second frame of a sum.
    gl::VertexArray noVertices_;
    shared::CameraData cameraData_{};  ///< Before the block, which is made from it.
    gl::Buffer cameraBlock_;
    GeometryPass geometry_;
    std::unique_ptr<EmitterPass> emitters_;
    std::unique_ptr<BlendPass> blend_;
    PassClock* clock_ = nullptr;
};

}  // namespace polylume
