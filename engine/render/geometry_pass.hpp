// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "render/gbuffer.hpp"
#include "render/gpu_scene.hpp"
#include "render/material_variant.hpp"

namespace polylume {

/// Writes opaque and masked surfaces into the bound G-buffer.
class GeometryPass {
  public:
    /// For G-buffers with the attachments of `gbuffer`. Keeps references to the first three.
    GeometryPass(const gl::Functions& gl, const gl::ShaderLibrary& library, const GpuScene& scene,
                 const GBuffer& gbuffer);

    /// The camera block is bound.
    void draw();

    /// The program for materials without textures and alpha MASK; null where the scene has no such
    /// opaque material, and it would be compiled for others alone.
    const gl::Program* plainProgram();

  private:
    const gl::Functions& gl_;
    const GpuScene& scene_;
    MaterialPrograms programs_;
    std::vector<int> order_;  ///< Instances, those of one material together.
    bool hasPlain_ = false;   ///< One of them has a material without textures and alpha MASK.
};

}  // namespace polylume
