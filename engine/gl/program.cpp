// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/program.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::gl {
namespace {

template <typename GetLog>
std::string readLog(GLint length, GetLog getLog) {
    std::string log(static_cast<std::size_t>(length), '\0');
    GLsizei written = 0;
    getLog(length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

Shader compile(const Functions& gl, const ShaderLibrary& library, GLenum stage,
               std::string_view path, std::span<const std::string> defines) {
    const ShaderSource source = library.expand(path, defines);
    Shader shader(gl, gl.CreateShader(stage));
    const char* text = source.text.c_str();
    gl.ShaderSource(shader.name(), 1, &text, nullptr);
    gl.CompileShader(shader.name());

    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        GLint length = 0;
        gl.GetShaderiv(shader.name(), GL_INFO_LOG_LENGTH, &length);
        const std::string log = readLog(length, [&](GLsizei size, GLsizei* written, char* buffer) {
            gl.GetShaderInfoLog(shader.name(), size, written, buffer);
        });
        throw ShaderError(concat(path, " does not compile:\n", nameFiles(log, source.files)));
    }
    return shader;
}

}  // namespace

Program::Program(const Functions& gl, const ShaderLibrary& library, std::string_view vertexPath,
                 std::string_view fragmentPath, std::span<const std::string> defines,
                 const char* label)
    : Program(gl, library.compileClock()) {
    const CompileClock::Scope scope(*clock_);
    const std::array paths = {vertexPath, fragmentPath};
    const std::array shaders = {compile(gl, library, GL_VERTEX_SHADER, vertexPath, defines),
                                compile(gl, library, GL_FRAGMENT_SHADER, fragmentPath, defines)};
    link(paths, shaders, label);
}

Program Program::compute(const Functions& gl, const ShaderLibrary& library, std::string_view path,
                         std::span<const std::string> defines, const char* label) {
    Program program(gl, library.compileClock());
    const CompileClock::Scope scope(*program.clock_);
    const Shader shader = compile(gl, library, GL_COMPUTE_SHADER, path, defines);
    program.link(std::span(&path, 1), std::span(&shader, 1), label);
    return program;
}

template <typename Draw>
void Program::compileBy(const Draw& draw) const {
    const Functions& gl = handle_.functions();
    GLint viewport[4] = {};
    gl.GetIntegerv(GL_VIEWPORT, viewport);
    // Without pixels, and with all that a driver compiles for: no state but the viewport is
    // another.
    gl.Viewport(0, 0, 0, 0);
    {
        const CompileClock::Scope scope(*clock_);
        draw();
    }
    gl.Viewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    clock_ = nullptr;
}

void Program::drawArrays(GLenum mode, GLint first, GLsizei count) const {
    const Functions& gl = handle_.functions();
    if (clock_ != nullptr) {
        compileBy([&] { gl.DrawArrays(mode, first, std::min(count, 3)); });
    }
    gl.DrawArrays(mode, first, count);
}

void Program::drawElements(GLenum mode, GLsizei count, std::size_t firstIndex) const {
    const Functions& gl = handle_.functions();
    const auto* const begin = reinterpret_cast<const void*>(firstIndex * sizeof(std::uint32_t));
    if (clock_ != nullptr) {
        compileBy([&] { gl.DrawElements(mode, std::min(count, 3), GL_UNSIGNED_INT, begin); });
    }
    gl.DrawElements(mode, count, GL_UNSIGNED_INT, begin);
}

void Program::link(std::span<const std::string_view> paths, std::span<const Shader> shaders,
                   const char* label) {
    const Functions& gl = handle_.functions();
    for (const Shader& shader : shaders) gl.AttachShader(name(), shader.name());
    gl.LinkProgram(name());
    for (const Shader& shader : shaders) gl.DetachShader(name(), shader.name());
    gl.ObjectLabel(GL_PROGRAM, name(), -1, label);

    GLint linked = GL_FALSE;
    gl.GetProgramiv(name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return;
    GLint length = 0;
    gl.GetProgramiv(name(), GL_INFO_LOG_LENGTH, &length);
    const std::string log = readLog(length, [&](GLsizei size, GLsizei* written, char* buffer) {
        gl.GetProgramInfoLog(name(), size, written, buffer);
    });
    std::string what;
    for (const std::string_view path : paths) what += concat(what.empty() ? "" : " and ", path);
    throw ShaderError(concat(what, paths.size() > 1 ? " do" : " does", " not link:\n", log));
}

}  // namespace polylume::gl
