// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <vector>

#include "gl/functions.hpp"

namespace polylume::embed {

/// Hands the values of a host's uniforms on, from the program of its snippet that it knows to one
/// that it does not. Every call needs the same context current.
class SnippetUniforms {
  public:
    /// Gives the uniforms of `to` that `from` has, too, the values that they have there; both with
    /// the same snippet. Those that begin with polylume are ours and stay. Allocates only where
    /// `from` or `to` is new.
    void copy(const gl::Functions& gl, GLuint from, GLuint to);

  private:
    struct Uniform {
        GLenum type;
        GLint count;  ///< Of an array.
        GLint from, to;
    };
    struct Pair {
        GLuint from, to;
        std::vector<Uniform> uniforms;
    };

    const Pair& find(const gl::Functions& gl, GLuint from, GLuint to);

    std::vector<Pair> pairs_;
};

}  // namespace polylume::embed
