// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/thread_context.hpp"

#include <array>
#include <exception>
#include <string_view>

#include "core/log.hpp"
#include "core/text.hpp"
#include "gl/software_renderer.hpp"
#include "polylume/error.hpp"

namespace polylume::context {
namespace {

thread_local ThreadContext* currentContext = nullptr;

std::string stringOf(const gl::Functions& gl, GLenum name) {
    const GLubyte* text = gl.GetString(name);
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

struct Limit {
    const char* name;
    GLenum value;
};

constexpr Limit kLimits[] = {
    {"texture size", GL_MAX_TEXTURE_SIZE},
    {"framebuffer width", GL_MAX_FRAMEBUFFER_WIDTH},
    {"framebuffer height", GL_MAX_FRAMEBUFFER_HEIGHT},
    {"color attachments", GL_MAX_COLOR_ATTACHMENTS},
    {"draw buffers", GL_MAX_DRAW_BUFFERS},
    {"texture units", GL_MAX_TEXTURE_IMAGE_UNITS},
    {"image units", GL_MAX_IMAGE_UNITS},
    {"uniform block bytes", GL_MAX_UNIFORM_BLOCK_SIZE},
    {"storage block bytes", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
    {"storage bindings", GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {"compute invocations", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS},
    {"compute shared bytes", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE},
};

}  // namespace

void ThreadContext::makeCurrent() {
    if (currentContext == this) return;
    releaseCurrent();
    bind();
    currentContext = this;
}

ThreadContext* ThreadContext::current() {
    return currentContext;
}

void ThreadContext::releaseCurrent() {
    if (currentContext == nullptr) return;
    currentContext->unbind();
    currentContext = nullptr;
}

std::vector<std::pair<std::string, std::string>> ThreadContext::limits() const {
    std::vector<std::pair<std::string, std::string>> result;
    for (const Limit& limit : kLimits) {
        GLint64 value = 0;
        functions_.GetInteger64v(limit.value, &value);
        result.emplace_back(limit.name, std::to_string(value));
    }
    std::string size;
    for (GLuint axis = 0; axis < 3; ++axis) {
        GLint value = 0;
        functions_.GetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_SIZE, axis, &value);
        if (axis > 0) size += 'x';
        size += std::to_string(value);
    }
    result.emplace_back("compute group size", size);
    return result;
}

void ThreadContext::start(const std::string& backend, GetFunction getFunction) {
    ThreadContext* before = currentContext;
    try {
        makeCurrent();
        loadFunctions(getFunction);
    } catch (...) {
        // Released here, as the destructor of an object that is not finished won't do it.
        if (currentContext == this) releaseCurrent();
        if (before != nullptr) before->makeCurrent();
        throw;
    }
    info_.backend = backend;
    info_.vendor = stringOf(functions_, GL_VENDOR);
    info_.renderer = stringOf(functions_, GL_RENDERER);
    info_.version = stringOf(functions_, GL_VERSION);
    info_.shadingLanguageVersion = stringOf(functions_, GL_SHADING_LANGUAGE_VERSION);
    info_.software = gl::isSoftwareRenderer(info_.renderer);
    debugLog_ = std::make_unique<gl::DebugLog>(functions_);
}

void ThreadContext::loadFunctions(GetFunction getFunction) {
    const int version = gladLoadGLContext(&functions_, getFunction);
    if (version == 0) throw ContextError("expected OpenGL 4.5, found no working GL_VERSION");
    if (version < GLAD_MAKE_VERSION(4, 5)) {
        throw ContextError(concat("expected OpenGL 4.5, found ", stringOf(functions_, GL_VERSION),
                                  " (", stringOf(functions_, GL_RENDERER), ")"));
    }
    GLint profile = 0;
    functions_.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if ((profile & GL_CONTEXT_CORE_PROFILE_BIT) == 0) {
        throw ContextError(
            concat("expected the core profile, found ", stringOf(functions_, GL_VERSION)));
    }
}

void ThreadContext::stop() noexcept {
    ThreadContext* before = currentContext;
    try {
        makeCurrent();
        debugLog_.reset();
        releaseCurrent();
        if (before != nullptr && before != this) before->makeCurrent();
    } catch (const std::exception& error) {
        log(LogLevel::warning, concat("while closing ", info_.backend, ": ", error.what()));
    }
}

}  // namespace polylume::context
