// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "render/gpu_scene.hpp"
#include "render/material_variant.hpp"

namespace polylume {

/// Writes opaque and masked surfaces into the bound G-buffer.
class GeometryPass {
  public:
    /// Keeps references to all three.
    GeometryPass(const gl::Functions& gl, const gl::ShaderLibrary& library, const GpuScene& scene);

    /// The camera block is bound.
    void draw();

  private:
    const gl::Functions& gl_;
    const GpuScene& scene_;
    MaterialPrograms programs_;
    std::vector<int> order_;  ///< Instances, those of one material together.
};

}  // namespace polylume
