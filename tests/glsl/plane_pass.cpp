// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "plane_pass.hpp"

#include <fstream>
#include <iterator>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::test {
namespace {

GLuint compile(const gl::Functions& gl, GLenum stage, const std::string& text) {
    const GLuint shader = gl.CreateShader(stage);
    const char* source = text.c_str();
    gl.ShaderSource(shader, 1, &source, nullptr);
    gl.CompileShader(shader);
    GLint success = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &success);
    if (success == GL_TRUE) return shader;
    std::string log(4096, '\0');
    gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteShader(shader);
    throw ShaderError(log.c_str());
}

}  // namespace

std::string readText(const char* path) {
    std::ifstream file(path);
    if (!file) throw Error(concat("expected a file ", path, ", found none"));
    return {std::istreambuf_iterator<char>(file), {}};
}

glm::dvec3 PlanePass::positionOf(std::size_t index) {
    const double column = static_cast<double>(index % kSize);
    const double row = static_cast<double>(index / kSize);
    return {(column + 0.5 - 16.0) / 8.0, (row + 0.5 - 16.0) / 8.0, 0.0};
}

PlanePass::PlanePass(const DialectContext& context, const std::string& fragment,
                     const std::string& define)
    : gl_(context.gl()) {
    const std::string head = context.versionLine() + define + "\n";
    const GLuint vertexShader =
        compile(gl_, GL_VERTEX_SHADER, head + readText(POLYLUME_PLANE_SHADER));
    const GLuint fragmentShader = compile(gl_, GL_FRAGMENT_SHADER, head + fragment);
    program_ = gl_.CreateProgram();
    gl_.AttachShader(program_, vertexShader);
    gl_.AttachShader(program_, fragmentShader);
    gl_.LinkProgram(program_);
    gl_.DeleteShader(vertexShader);
    gl_.DeleteShader(fragmentShader);
    GLint success = 0;
    gl_.GetProgramiv(program_, GL_LINK_STATUS, &success);
    if (success != GL_TRUE) {
        std::string log(4096, '\0');
        gl_.GetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
        throw ShaderError(log.c_str());
    }
    gl_.UseProgram(program_);

    gl_.GenVertexArrays(1, &vertexArray_);
    gl_.BindVertexArray(vertexArray_);
    gl_.GenRenderbuffers(1, &target_);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, target_);
    gl_.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kSize, kSize);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target_);
}

PlanePass::~PlanePass() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteRenderbuffers(1, &target_);
    gl_.DeleteVertexArrays(1, &vertexArray_);
    gl_.DeleteProgram(program_);
}

void PlanePass::set(const char* uniform, float value) const {
    gl_.Uniform1f(gl_.GetUniformLocation(program_, uniform), value);
}

void PlanePass::set(const char* uniform, const glm::vec3& value) const {
    set(uniform, std::span(&value, 1));
}

void PlanePass::set(const char* uniform, std::span<const glm::vec3> values) const {
    gl_.Uniform3fv(gl_.GetUniformLocation(program_, uniform), static_cast<GLsizei>(values.size()),
                   &values.front().x);
}

std::vector<glm::vec4> PlanePass::draw(GLuint table) const {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D_ARRAY, table);
    gl_.Viewport(0, 0, kSize, kSize);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<glm::vec4> pixels(static_cast<std::size_t>(kSize) * kSize);
    gl_.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_FLOAT, pixels.data());
    const GLenum error = gl_.GetError();
    if (error != GL_NO_ERROR) throw Error(concat("expected no GL error, found ", error));
    return pixels;
}

}  // namespace polylume::test
