// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gl/compile_clock.hpp"
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

    /// glDrawArrays() and glDrawElements() of 32-bit indices, with this program in use and all
    /// other state set. The first draw comes twice: as one triangle without a pixel, for the
    /// driver to compile by, on the library's clock, and then as it is.
    void drawArrays(GLenum mode, GLint first, GLsizei count) const;
    void drawElements(GLenum mode, GLsizei count, std::size_t firstIndex) const;

    GLuint name() const { return handle_.name(); }
    bool isEmpty() const { return handle_.isEmpty(); }

  private:
    Program(const Functions& gl, std::shared_ptr<CompileClock> clock)
        : handle_(gl, gl.CreateProgram()), clock_(std::move(clock)) {}
    /// Links the stages of `paths`. Throws ShaderError that names them.
    void link(std::span<const std::string_view> paths, std::span<const Shader> shaders,
              const char* label);

    static void destroy(const Functions& gl, GLuint name) { gl.DeleteProgram(name); }
    /// Calls `draw`, which draws the beginning of the first draw, with no pixel to fill.
    template <typename Draw>
    void compileBy(const Draw& draw) const;

    Handle<&Program::destroy> handle_;
    /// Null once it has drawn.
    mutable std::shared_ptr<CompileClock> clock_;
};

}  // namespace polylume::gl
