// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "gl/handle.hpp"

namespace polylume::embed {

/// A framebuffer for targets that are textures. Contexts share none, so that it also tells the one
/// that it was made in from all others.
class OwnFramebuffer {
  public:
    explicit OwnFramebuffer(const gl::Functions& gl);

    GLuint name() const { return handle_.name(); }

    /// Throws Error where that context is not current. Allocates nothing.
    void checkContext() const;

  private:
    static void destroy(const gl::Functions& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }

    std::string label_;  ///< No other object of the process has it.
    gl::Handle<&destroy> handle_;
};

}  // namespace polylume::embed
