// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include "context/egl_library.hpp"
#include "context/thread_context.hpp"

namespace polylume::context {

/// A context of libEGL without a window: without a surface where EGL allows, else on a tiny
/// pbuffer.
class EglContext final : public ThreadContext {
  public:
    /// Throws ContextError with the step that failed.
    explicit EglContext(const EglLibrary::Place& place);
    ~EglContext() override;

  private:
    void bind() override;
    void unbind() noexcept override;

    void createContext();
    EGLContext createVersion(EGLConfig config, int major, int minor) const;
    void destroy() noexcept;

    const EglLibrary& egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace polylume::context
