// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/host_functions.hpp"

#include <exception>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::embed {
namespace {

constexpr const char* kExpected =
    "expected a current context of OpenGL 4.5 or later when an AreaLighting is made, found ";

/// Brings exceptions of a host around the loader, which is C.
struct Loader {
    const GetProcAddress& getProcAddress;
    std::exception_ptr failure;

    static GLADapiproc load(void* self, const char* name) {
        auto& loader = *static_cast<Loader*>(self);
        if (loader.failure) return nullptr;
        try {
            return loader.getProcAddress(name);
        } catch (...) {
            loader.failure = std::current_exception();
            return nullptr;
        }
    }
};

const char* textOf(const gl::Functions& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

gl::Functions loadFunctions(const GetProcAddress& getProcAddress) {
    if (!getProcAddress) throw ContextError("expected a getProcAddress, found an empty function");
    gl::Functions gl{};
    Loader loader{getProcAddress, nullptr};
    const int version = gladLoadGLContextUserPtr(&gl, &Loader::load, &loader);
    if (loader.failure) std::rethrow_exception(loader.failure);
    if (version == 0) {
        throw ContextError(concat(kExpected,
                                  "no answer to glGetString(GL_VERSION): make the context current "
                                  "in this thread first"));
    }
    if (version < GLAD_MAKE_VERSION(4, 5)) {
        throw ContextError(concat(kExpected, textOf(gl, GL_VERSION), " (", textOf(gl, GL_RENDERER),
                                  "); ask for version 4.5 when the context is made"));
    }
    // The newest parts, which a loader of its own may not know.
    if (gl.CreateBuffers == nullptr || gl.NamedBufferStorage == nullptr ||
        gl.BindBuffersBase == nullptr || gl.DispatchCompute == nullptr ||
        gl.GetTextureLevelParameteriv == nullptr || gl.TextureBarrier == nullptr) {
        throw ContextError(
            "expected getProcAddress to find the functions of OpenGL 4.5, found that it gives null "
            "for some, as glCreateBuffers");
    }
    return gl;
}

}  // namespace polylume::embed
