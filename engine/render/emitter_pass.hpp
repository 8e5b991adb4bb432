// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "lighting/lighting_pass.hpp"
#include "render/block_array.hpp"
#include "shared/emitter_data.h"

namespace polylume {

/// Writes area lights into the bound G-buffer as surfaces that emit and reflect nothing, seen from
/// the sides that emit.
class EmitterPass {
  public:
    /// Takes over the lights that `lighting` has now. Keeps references to the first and last.
    EmitterPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                const LightingPass& lighting);

    /// The camera block is bound.
    void draw() const;

  private:
    const gl::Functions& gl_;
    const LightingPass& lighting_;
    gl::Program program_;
    gl::VertexArray noVertices_;
    BlockArray<shared::EmitterData> emitters_;
    int emitterCount_ = 0;
};

}  // namespace polylume
