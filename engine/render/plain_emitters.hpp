// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "render/block_array.hpp"
#include "shared/emitter_data.h"
#include "shared/instance_data.h"
#include "shared/material_data.h"

namespace polylume {

/// Whether all of an emitter's rectangle shines, and evenly.
bool isPlain(const shared::EmitterData& emitter);

/// Plain emitters as meshes, for the program that draws meshes without textures: where a scene has
/// such meshes, the emitters' own program needs not be compiled, which takes longer than all else
/// that a small picture needs of it.
class PlainEmitters {
  public:
    PlainEmitters() = default;
    PlainEmitters(const gl::Functions& gl, const std::vector<shared::EmitterData>& emitters);

    /// Draws them by `program`, of passes/mesh.vert and passes/gbuffer.frag. The camera block is
    /// bound, and depth test and winding are set.
    void draw(const gl::Program& program) const;

    bool isEmpty() const { return twoSided_.empty(); }

  private:
    const gl::Functions* gl_ = nullptr;
    gl::Buffer positions_;
    gl::Buffer normals_;
    gl::VertexArray vertexArray_;
    BlockArray<shared::MaterialData> materials_;  ///< One an emitter.
    BlockArray<shared::InstanceData> place_;      ///< One: they are in world space.
    std::vector<bool> twoSided_;                  ///< One an emitter.
};

}  // namespace polylume
