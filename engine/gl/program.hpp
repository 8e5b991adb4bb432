// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gl/handle.hpp"
#include "gl/shader_library.hpp"

namespace polylume::gl {

inline void destroyShader(const Functions& gl, GLuint name) {
    gl.DeleteShader(name);
}
using Shader = Handle<&destroyShader>;

/// A linked program of a vertex and a fragment shader, or of a compute shader.
class Program {
  public:
    Program() = default;
    /// Assembles, compiles and links `vertexPath` and `fragmentPath` of the library, both with
    /// `defines`. Throws ShaderError with the driver's log, its lines named by file.
    Program(const Functions& gl, const ShaderLibrary& library, std::string_view vertexPath,
            std::string_view fragmentPath, std::span<const std::string> defines, const char* label);

    /// The same of the compute shader `path`.
    static Program compute(const Functions& gl, const ShaderLibrary& library, std::string_view path,
                           std::span<const std::string> defines, const char* label);

    void use() const { handle_.functions().UseProgram(name()); }
    GLuint name() const { return handle_.name(); }
    bool isEmpty() const { return handle_.isEmpty(); }

  private:
    explicit Program(const Functions& gl) : handle_(gl, gl.CreateProgram()) {}
    /// Links the stages of `paths`. Throws ShaderError that names them.
    void link(std::span<const std::string_view> paths, std::span<const Shader> shaders,
              const char* label);

    static void destroy(const Functions& gl, GLuint name) { gl.DeleteProgram(name); }
    Handle<&Program::destroy> handle_;
};

}  // namespace polylume::gl
