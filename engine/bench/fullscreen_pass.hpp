// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <string>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/shader_library.hpp"

namespace polylume::bench {

/// A fragment shader over a picture of its own, in the format that lighting is drawn in.
class FullscreenPass {
  public:
    FullscreenPass(const gl::Functions& gl, const gl::ShaderLibrary& library,
                   std::string_view fragmentPath, std::span<const std::string> defines,
                   glm::ivec2 size);

    /// Draws with what is bound by now.
    void draw() const;

    const gl::Program& program() const { return program_; }
    const gl::Texture& target() const { return target_; }

  private:
    const gl::Functions* gl_;
    gl::Program program_;
    gl::Texture target_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace polylume::bench
