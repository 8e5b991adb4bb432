// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/osmesa_context.hpp"

#include "context/dynamic_library.hpp"
#include "polylume/error.hpp"

namespace polylume::context {

// The interface of Mesa's OSMesa, declared here so that its headers are not needed.
struct OsmesaLibrary {
    void* (*createContextAttribs)(const int* attributes, void* shareWith) = nullptr;
    GLboolean (*makeCurrent)(void* context, void* buffer, GLenum type, GLsizei width,
                             GLsizei height) = nullptr;
    void (*destroyContext)(void* context) = nullptr;
    void (*(*getProcAddress)(const char* name))() = nullptr;

    static const OsmesaLibrary& get() {
        // Left alone at the end of the program, like the library itself.
        static const OsmesaLibrary* library = new OsmesaLibrary();
        return *library;
    }

  private:
    OsmesaLibrary() : library_({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        library_.fetch("OSMesaCreateContextAttribs", createContextAttribs);
        library_.fetch("OSMesaMakeCurrent", makeCurrent);
        library_.fetch("OSMesaDestroyContext", destroyContext);
        library_.fetch("OSMesaGetProcAddress", getProcAddress);
    }

    DynamicLibrary library_;
};

namespace {

// Names of attributes of OSMesaCreateContextAttribs().
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaContextMajorVersion = 0x36;
constexpr int kOsmesaContextMinorVersion = 0x37;

void* createVersion(const OsmesaLibrary& osmesa, int major, int minor) {
    const std::array<int, 9> attributes = {kOsmesaFormat,
                                           GL_RGBA,
                                           kOsmesaProfile,
                                           kOsmesaCoreProfile,
                                           kOsmesaContextMajorVersion,
                                           major,
                                           kOsmesaContextMinorVersion,
                                           minor,
                                           0};
    return osmesa.createContextAttribs(attributes.data(), nullptr);
}

}  // namespace

OsmesaContext::OsmesaContext() : osmesa_(OsmesaLibrary::get()) {
    context_ = createVersion(osmesa_, 4, 5);
    // The least core version. Mesa gives its newest one for it, and start() says which.
    if (context_ == nullptr) context_ = createVersion(osmesa_, 3, 2);
    if (context_ == nullptr) {
        throw ContextError("OSMesaCreateContextAttribs gives no OpenGL 4.5 core context");
    }
    try {
        start(kName, osmesa_.getProcAddress);
    } catch (...) {
        osmesa_.destroyContext(context_);
        throw;
    }
}

OsmesaContext::~OsmesaContext() {
    stop();
    osmesa_.destroyContext(context_);
}

void OsmesaContext::bind() {
    if (osmesa_.makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, kBufferSize, kBufferSize) !=
        GL_TRUE) {
        throw ContextError("OSMesaMakeCurrent failed");
    }
}

void OsmesaContext::unbind() noexcept {
    osmesa_.makeCurrent(nullptr, nullptr, 0, 0, 0);
}

}  // namespace polylume::context
