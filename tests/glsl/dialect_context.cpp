// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "dialect_context.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "polylume/error.hpp"

namespace polylume::test {
namespace {

using context::EglLibrary;

/// Mesa's llvmpipe gives its newest version to whoever asks for an older one, unless it is told.
void limitMesa() {
    ::setenv("MESA_GL_VERSION_OVERRIDE", "3.3", 1);
    ::setenv("MESA_GLSL_VERSION_OVERRIDE", "330", 1);
    ::setenv("MESA_GLES_VERSION_OVERRIDE", "3.0", 1);
}

EGLDisplay openSurfaceless(const EglLibrary& egl) {
    const std::vector<EglLibrary::Place> places = egl.places();
    const auto place = std::ranges::find(places, "EGL surfaceless", &EglLibrary::Place::name);
    if (place == places.end()) {
        throw ContextError("expected EGL_MESA_platform_surfaceless, found no such platform");
    }
    return egl.openDisplay(*place);
}

}  // namespace

DialectContext::DialectContext(Dialect dialect)
    : egl_(EglLibrary::get()),
      versionLine_(dialect == Dialect::es300 ? "#version 300 es\n" : "#version 330 core\n") {
    limitMesa();
    display_ = openSurfaceless(egl_);
    const bool isEs = dialect == Dialect::es300;
    if (egl_.bindApi(isEs ? EGL_OPENGL_ES_API : EGL_OPENGL_API) != EGL_TRUE) {
        throw ContextError(egl_.describeFailure("eglBindAPI"));
    }
    std::vector<EGLint> attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR, 3,
                                      EGL_CONTEXT_MINOR_VERSION_KHR, isEs ? 0 : 3};
    if (!isEs) {
        attributes.insert(attributes.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR});
    }
    attributes.push_back(EGL_NONE);
    context_ = egl_.createContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
    if (context_ == EGL_NO_CONTEXT) throw ContextError(egl_.describeFailure("eglCreateContext"));
    if (egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE ||
        gladLoadGLContext(&gl_, egl_.getProcAddress) == 0) {
        const std::string failure = egl_.describeFailure("eglMakeCurrent");
        egl_.destroyContext(display_, context_);
        throw ContextError(failure);
    }
}

DialectContext::~DialectContext() {
    egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroyContext(display_, context_);
}

std::string DialectContext::version() const {
    return reinterpret_cast<const char*>(gl_.GetString(GL_VERSION));
}

bool DialectContext::hasExtension(const std::string& name) const {
    GLint count = 0;
    gl_.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* found = gl_.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name == reinterpret_cast<const char*>(found)) return true;
    }
    return false;
}

}  // namespace polylume::test
