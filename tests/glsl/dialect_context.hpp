// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>

#include "context/egl_library.hpp"
#include "gl/functions.hpp"

namespace polylume::test {

/// A kind of context and the GLSL that its shaders are written in.
enum class Dialect { core330, es300 };

/// A context of the least version that has a GLSL, on EGL without a window, current from its making
/// to its end. Mesa then refuses what the version lacks; other drivers may give a newer context,
/// whose compilers still go by the version that a shader asks for.
class DialectContext {
  public:
    /// Throws ContextError.
    explicit DialectContext(Dialect dialect);
    ~DialectContext();
    DialectContext(const DialectContext&) = delete;
    DialectContext& operator=(const DialectContext&) = delete;

    const gl::Functions& gl() const { return gl_; }

    /// What a shader begins with: "#version 330 core\n".
    const char* versionLine() const { return versionLine_; }

    /// GL_VERSION.
    std::string version() const;

    bool hasExtension(const std::string& name) const;

  private:
    const context::EglLibrary& egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    gl::Functions gl_{};
    const char* versionLine_;
};

}  // namespace polylume::test
