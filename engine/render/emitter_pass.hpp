// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "lighting/lighting_pass.hpp"
#include "render/block_array.hpp"
#include "render/geometry_pass.hpp"
#include "render/plain_emitters.hpp"
#include "shared/emitter_data.h"

namespace polylume {

/// Writes area lights into the bound G-buffer as surfaces that emit and reflect nothing, seen from
/// the sides that emit: a ball or tube from outside, a two-sided one from inside, too.
class EmitterPass {
  public:
    /// Takes over the lights that `lighting` has now. `geometry`, or null, lends its program for
    /// plain emitters, which it draws before. Keeps references to all.
    EmitterPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                const LightingPass& lighting, GeometryPass* geometry = nullptr);

    /// Takes over the lights that the lighting pass has by now. Leaves the old ones where it throws
    /// ShaderError.
    void updateLights();

    /// The camera block is bound.
    void draw() const;

  private:
    /// Lights that are drawn alike; without any, without a program.
    struct Batch {
        std::shared_ptr<const gl::Program> program;
        std::vector<std::string> defines;  ///< Of the program.
        BlockArray<shared::EmitterData> emitters;
        int count = 0;
    };

    /// `old` is what is drawn now; its program serves on where its defines are those of today.
    Batch makeBatch(const std::vector<shared::EmitterData>& emitters, const Batch& old,
                    const char* label, const char* vertexPath, const char* fragmentPath) const;
    void draw(const Batch& batch, GLenum mode, int vertexCount) const;

    const gl::Functions& gl_;
    const gl::ShaderLibrary& library_;
    const LightingPass& lighting_;
    GeometryPass* const geometry_;
    gl::VertexArray noVertices_;
    PlainEmitters plain_;  ///< Where the geometry pass has a program for them.
    Batch flat_;           ///< The other flat ones, by their bounding rectangles.
    Batch solid_;          ///< By their bounding boxes.
};

}  // namespace polylume
