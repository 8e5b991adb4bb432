// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <vector>

#include "lighting/lighting_pass.hpp"
#include "render/gpu_scene.hpp"
#include "render/material_variant.hpp"

namespace polylume {

/// Draws transparent surfaces, shaded by the lighting pass's own code, over the lit picture,
/// triangles back to front. Triangles that pass through each other are not split.
class BlendPass {
  public:
    /// Sorts for `camera`. Keeps references to the first four.
    BlendPass(const gl::Functions& gl, const gl::ShaderLibrary& library, const GpuScene& scene,
              const LightingPass& lighting, const scene::Camera& camera);

    /// Sorts anew, for another camera.
    void sortFor(const scene::Camera& camera);
    /// Takes over what the lighting pass's lights ask of the shaders by now.
    void updateLights();

    /// Draws into the bound framebuffer, which has the G-buffer's depth. The camera block is bound.
    void draw();

  private:
    /// Neighbours in the order that belong to one instance.
    struct Run {
        int instance = 0;
        std::size_t firstIndex = 0;
        int indexCount = 0;
    };

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    const GpuScene& scene_;
    const LightingPass& lighting_;
    std::vector<std::string> defines_;  ///< Of the programs.
    MaterialPrograms programs_;
    gl::Buffer indices_;
    std::vector<gl::VertexArray> vertexArrays_;  ///< One an instance, empty where it is opaque.
    std::vector<Run> runs_;
};

}  // namespace polylume
