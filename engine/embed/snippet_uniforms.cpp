// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/snippet_uniforms.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace polylume::embed {
namespace {

using Gl = gl::Functions;

/// How a uniform of a type is set.
template <typename Value>
struct VectorType {
    GLenum type;
    void (GLAD_API_PTR* Gl::*set)(GLuint, GLint, GLsizei, const Value*);
};
template <typename Value>
struct MatrixType {
    GLenum type;
    void (GLAD_API_PTR* Gl::*set)(GLuint, GLint, GLsizei, GLboolean, const Value*);
};

constexpr VectorType<GLfloat> kFloats[] = {{GL_FLOAT, &Gl::ProgramUniform1fv},
                                           {GL_FLOAT_VEC2, &Gl::ProgramUniform2fv},
                                           {GL_FLOAT_VEC3, &Gl::ProgramUniform3fv},
                                           {GL_FLOAT_VEC4, &Gl::ProgramUniform4fv}};
constexpr VectorType<GLdouble> kDoubles[] = {{GL_DOUBLE, &Gl::ProgramUniform1dv},
                                             {GL_DOUBLE_VEC2, &Gl::ProgramUniform2dv},
                                             {GL_DOUBLE_VEC3, &Gl::ProgramUniform3dv},
                                             {GL_DOUBLE_VEC4, &Gl::ProgramUniform4dv}};
constexpr VectorType<GLuint> kUnsigned[] = {{GL_UNSIGNED_INT, &Gl::ProgramUniform1uiv},
                                            {GL_UNSIGNED_INT_VEC2, &Gl::ProgramUniform2uiv},
                                            {GL_UNSIGNED_INT_VEC3, &Gl::ProgramUniform3uiv},
                                            {GL_UNSIGNED_INT_VEC4, &Gl::ProgramUniform4uiv}};
constexpr VectorType<GLint> kIntegers[] = {
    {GL_INT_VEC2, &Gl::ProgramUniform2iv},  {GL_INT_VEC3, &Gl::ProgramUniform3iv},
    {GL_INT_VEC4, &Gl::ProgramUniform4iv},  {GL_BOOL_VEC2, &Gl::ProgramUniform2iv},
    {GL_BOOL_VEC3, &Gl::ProgramUniform3iv}, {GL_BOOL_VEC4, &Gl::ProgramUniform4iv}};
constexpr MatrixType<GLfloat> kMatrices[] = {{GL_FLOAT_MAT2, &Gl::ProgramUniformMatrix2fv},
                                             {GL_FLOAT_MAT3, &Gl::ProgramUniformMatrix3fv},
                                             {GL_FLOAT_MAT4, &Gl::ProgramUniformMatrix4fv},
                                             {GL_FLOAT_MAT2x3, &Gl::ProgramUniformMatrix2x3fv},
                                             {GL_FLOAT_MAT2x4, &Gl::ProgramUniformMatrix2x4fv},
                                             {GL_FLOAT_MAT3x2, &Gl::ProgramUniformMatrix3x2fv},
                                             {GL_FLOAT_MAT3x4, &Gl::ProgramUniformMatrix3x4fv},
                                             {GL_FLOAT_MAT4x2, &Gl::ProgramUniformMatrix4x2fv},
                                             {GL_FLOAT_MAT4x3, &Gl::ProgramUniformMatrix4x3fv}};
constexpr MatrixType<GLdouble> kDoubleMatrices[] = {
    {GL_DOUBLE_MAT2, &Gl::ProgramUniformMatrix2dv},
    {GL_DOUBLE_MAT3, &Gl::ProgramUniformMatrix3dv},
    {GL_DOUBLE_MAT4, &Gl::ProgramUniformMatrix4dv},
    {GL_DOUBLE_MAT2x3, &Gl::ProgramUniformMatrix2x3dv},
    {GL_DOUBLE_MAT2x4, &Gl::ProgramUniformMatrix2x4dv},
    {GL_DOUBLE_MAT3x2, &Gl::ProgramUniformMatrix3x2dv},
    {GL_DOUBLE_MAT3x4, &Gl::ProgramUniformMatrix3x4dv},
    {GL_DOUBLE_MAT4x2, &Gl::ProgramUniformMatrix4x2dv},
    {GL_DOUBLE_MAT4x3, &Gl::ProgramUniformMatrix4x3dv}};

/// A value on its way: those of the programs, and where in each.
struct Way {
    const Gl& gl;
    GLuint fromProgram, toProgram;
    GLint from, to;
};

/// A mat4 has the most numbers.
template <typename Value>
using Values = std::array<Value, 16>;

Values<GLfloat> read(const Way& way, GLfloat) {
    Values<GLfloat> values{};
    way.gl.GetUniformfv(way.fromProgram, way.from, values.data());
    return values;
}

Values<GLdouble> read(const Way& way, GLdouble) {
    Values<GLdouble> values{};
    way.gl.GetUniformdv(way.fromProgram, way.from, values.data());
    return values;
}

Values<GLuint> read(const Way& way, GLuint) {
    Values<GLuint> values{};
    way.gl.GetUniformuiv(way.fromProgram, way.from, values.data());
    return values;
}

Values<GLint> read(const Way& way, GLint) {
    Values<GLint> values{};
    way.gl.GetUniformiv(way.fromProgram, way.from, values.data());
    return values;
}

/// False where `type` is none of `types`.
template <typename Value, std::size_t count>
bool copyVector(const Way& way, GLenum type, const VectorType<Value> (&types)[count]) {
    const auto found = std::ranges::find(types, type, &VectorType<Value>::type);
    if (found == std::end(types)) return false;
    (way.gl.*found->set)(way.toProgram, way.to, 1, read(way, Value{}).data());
    return true;
}

template <typename Value, std::size_t count>
bool copyMatrix(const Way& way, GLenum type, const MatrixType<Value> (&types)[count]) {
    const auto found = std::ranges::find(types, type, &MatrixType<Value>::type);
    if (found == std::end(types)) return false;
    (way.gl.*found->set)(way.toProgram, way.to, 1, GL_FALSE, read(way, Value{}).data());
    return true;
}

void copyValue(const Way& way, GLenum type) {
    if (copyVector(way, type, kFloats) || copyMatrix(way, type, kMatrices) ||
        copyVector(way, type, kUnsigned) || copyVector(way, type, kIntegers) ||
        copyVector(way, type, kDoubles) || copyMatrix(way, type, kDoubleMatrices)) {
        return;
    }
    // An integer, a truth value, or the unit of a sampler or image.
    way.gl.ProgramUniform1iv(way.toProgram, way.to, 1, read(way, GLint{}).data());
}

}  // namespace

const SnippetUniforms::Pair& SnippetUniforms::find(const Gl& gl, GLuint from, GLuint to) {
    const auto found = std::ranges::find_if(
        pairs_, [&](const Pair& pair) { return pair.from == from && pair.to == to; });
    if (found != pairs_.end()) return *found;

    Pair pair{from, to, {}};
    GLint count = 0, length = 0;
    gl.GetProgramiv(from, GL_ACTIVE_UNIFORMS, &count);
    gl.GetProgramiv(from, GL_ACTIVE_UNIFORM_MAX_LENGTH, &length);
    std::vector<GLchar> name(static_cast<std::size_t>(std::max(length, 1)));
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        Uniform uniform{};
        gl.GetActiveUniform(from, i, static_cast<GLsizei>(name.size()), nullptr, &uniform.count,
                            &uniform.type, name.data());
        // Members of blocks have no location.
        uniform.from = gl.GetUniformLocation(from, name.data());
        uniform.to = gl.GetUniformLocation(to, name.data());
        const bool isOurs = std::string_view(name.data()).starts_with("polylume");
        if (uniform.from >= 0 && uniform.to >= 0 && !isOurs) pair.uniforms.push_back(uniform);
    }
    // Of an array a program has as much as it uses.
    gl.GetProgramiv(to, GL_ACTIVE_UNIFORMS, &count);
    gl.GetProgramiv(to, GL_ACTIVE_UNIFORM_MAX_LENGTH, &length);
    name.resize(static_cast<std::size_t>(std::max(length, 1)));
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        GLint elements = 0;
        GLenum type = GL_NONE;
        gl.GetActiveUniform(to, i, static_cast<GLsizei>(name.size()), nullptr, &elements, &type,
                            name.data());
        const GLint location = gl.GetUniformLocation(to, name.data());
        const auto uniform = std::ranges::find(pair.uniforms, location, &Uniform::to);
        if (uniform != pair.uniforms.end()) uniform->count = std::min(uniform->count, elements);
    }
    pairs_.push_back(std::move(pair));
    return pairs_.back();
}

void SnippetUniforms::copy(const Gl& gl, GLuint from, GLuint to) {
    const Pair& pair = find(gl, from, to);
    for (const Uniform& uniform : pair.uniforms) {
        for (GLint i = 0; i < uniform.count; ++i) {
            copyValue({gl, from, to, uniform.from + i, uniform.to + i}, uniform.type);
        }
    }
}

}  // namespace polylume::embed
