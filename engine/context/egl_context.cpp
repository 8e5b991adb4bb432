// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/egl_context.hpp"

#include <array>
#include <string>

#include "polylume/error.hpp"

namespace polylume::context {

EglContext::EglContext(const EglLibrary::Place& place) : egl_(EglLibrary::get()) {
    display_ = egl_.openDisplay(place);
    try {
        createContext();
        start(place.name, egl_.getProcAddress);
    } catch (...) {
        destroy();
        throw;
    }
}

EglContext::~EglContext() {
    stop();
    destroy();
}

EGLContext EglContext::createVersion(EGLConfig config, int major, int minor) const {
    // The KHR names and values, which EGL 1.5 took over but for the debug flag, and still accepts.
    const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                              major,
                                              EGL_CONTEXT_MINOR_VERSION_KHR,
                                              minor,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                              EGL_CONTEXT_FLAGS_KHR,
                                              EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                              EGL_NONE};
    return egl_.createContext(display_, config, EGL_NO_CONTEXT, attributes.data());
}

void EglContext::createContext() {
    if (egl_.bindApi(EGL_OPENGL_API) != EGL_TRUE) {
        throw ContextError(egl_.describeFailure("eglBindAPI(EGL_OPENGL_API)"));
    }
    const bool surfaceless = egl_.hasExtension(display_, "EGL_KHR_surfaceless_context");
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!surfaceless || !egl_.hasExtension(display_, "EGL_KHR_no_config_context")) {
        const EGLint wanted[] = {EGL_SURFACE_TYPE, surfaceless ? 0 : EGL_PBUFFER_BIT,
                                 EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLint count = 0;
        if (egl_.chooseConfig(display_, wanted, &config, 1, &count) != EGL_TRUE || count == 0) {
            throw ContextError(egl_.describeFailure("eglChooseConfig"));
        }
    }

    context_ = createVersion(config, 4, 5);
    if (context_ == EGL_NO_CONTEXT) {
        const std::string failure = egl_.describeFailure("eglCreateContext for OpenGL 4.5 core");
        // The least core version. A driver gives its newest one for it, and start() says which.
        context_ = createVersion(config, 3, 2);
        if (context_ == EGL_NO_CONTEXT) throw ContextError(failure);
    }
    if (!surfaceless) {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface_ = egl_.createPbufferSurface(display_, config, size);
        if (surface_ == EGL_NO_SURFACE) {
            throw ContextError(egl_.describeFailure("eglCreatePbufferSurface"));
        }
    }
}

void EglContext::destroy() noexcept {
    if (surface_ != EGL_NO_SURFACE) egl_.destroySurface(display_, surface_);
    if (context_ != EGL_NO_CONTEXT) egl_.destroyContext(display_, context_);
}

void EglContext::bind() {
    // The API is a state of the thread, and decides which context eglMakeCurrent() lets go.
    egl_.bindApi(EGL_OPENGL_API);
    if (egl_.makeCurrent(display_, surface_, surface_, context_) != EGL_TRUE) {
        throw ContextError(egl_.describeFailure("eglMakeCurrent"));
    }
}

void EglContext::unbind() noexcept {
    egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace polylume::context
