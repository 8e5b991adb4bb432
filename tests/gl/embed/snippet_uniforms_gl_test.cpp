// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/snippet_uniforms.hpp"

#include <gmock/gmock.h>

#include <array>
#include <numeric>
#include <string>

#include "core/text.hpp"
#include "gl/objects.hpp"
#include "gl/support/gl_test.hpp"

namespace polylume {
namespace {

class SnippetUniformsTest : public test::GlTest {
  protected:
    /// A compute shader that declares uniforms and writes a number that depends on them.
    GLuint makeProgram(const std::string& declarations, const std::string& number) {
        const std::string text = concat(
            "#version 450 core\nlayout(local_size_x = 1) in;\n"
            "layout(std430, binding = 0) writeonly buffer Out { double number; };\n",
            declarations, "\nvoid main() { number = ", number, "; }\n");
        const GLuint shader = gl().CreateShader(GL_COMPUTE_SHADER);
        const char* const lines = text.c_str();
        gl().ShaderSource(shader, 1, &lines, nullptr);
        gl().CompileShader(shader);
        const GLuint program = gl().CreateProgram();
        gl().AttachShader(program, shader);
        gl().LinkProgram(program);
        gl().DeleteShader(shader);
        GLint isLinked = GL_FALSE;
        gl().GetProgramiv(program, GL_LINK_STATUS, &isLinked);
        std::array<GLchar, 1000> log{};
        gl().GetProgramInfoLog(program, log.size(), nullptr, log.data());
        EXPECT_EQ(isLinked, GL_TRUE) << log.data() << text;
        programs_.push_back(program);
        return program;
    }

    double run(GLuint program) {
        const gl::Buffer out = gl::Buffer::ofSize(gl(), sizeof(double), 0, "out");
        gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, out.name());
        gl().UseProgram(program);
        gl().DispatchCompute(1, 1, 1);
        gl().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        double number = 0.0;
        gl().GetNamedBufferSubData(out.name(), 0, sizeof(number), &number);
        return number;
    }

    void TearDown() override {
        gl().UseProgram(0);
        for (const GLuint program : programs_) gl().DeleteProgram(program);
        GlTest::TearDown();
    }

  private:
    std::vector<GLuint> programs_;
};

/// The sum of all numbers of `x`, each with another weight, in GLSL.
std::string sumOf(int columns, int rows) {
    std::string sum = "0.0lf";
    int weight = 1;
    for (int c = 0; c < columns; ++c) {
        for (int r = 0; r < rows; ++r) {
            std::string element = columns > 1 ? concat("x[", c, "]") : "x";
            if (rows > 1) element += concat("[", r, "]");
            sum += concat(" + ", weight++, " * double(", element, ")");
        }
    }
    return sum;
}

TEST_P(SnippetUniformsTest, everyType) {
    struct Type {
        std::string name;
        int columns, rows;
    };
    std::vector<Type> types = {
        {"float", 1, 1}, {"double", 1, 1}, {"int", 1, 1}, {"uint", 1, 1}, {"bool", 1, 1}};
    for (int n = 2; n <= 4; ++n) {
        for (const char* prefix : {"vec", "dvec", "ivec", "uvec", "bvec"}) {
            types.push_back({concat(prefix, n), 1, n});
        }
        for (int columns = 2; columns <= 4; ++columns) {
            types.push_back({concat("mat", columns, "x", n), columns, n});
            types.push_back({concat("dmat", columns, "x", n), columns, n});
        }
    }
    embed::SnippetUniforms uniforms;
    for (const Type& type : types) {
        // 1, 2, 3, or of truths the first one.
        const std::string number = sumOf(type.columns, type.rows);
        const std::string zero = concat("uniform ", type.name, " x;");
        std::string values;
        const bool isBool = type.name.starts_with("b");
        for (int i = 0; i < type.columns * type.rows; ++i) {
            values +=
                concat(i > 0 ? ", " : "", isBool ? (i == 0 ? "true" : "false") : concat(i + 1));
        }
        const GLuint from = makeProgram(
            concat("uniform ", type.name, " x = ", type.name, "(", values, ");"), number);
        const GLuint to = makeProgram(zero, number);
        EXPECT_EQ(run(to), 0.0) << type.name;
        uniforms.copy(gl(), from, to);
        EXPECT_EQ(run(to), run(from)) << type.name;
        EXPECT_GT(run(from), 0.0) << type.name;
    }
}

TEST_P(SnippetUniformsTest, arraysAsFarAsBothHaveThem) {
    const std::string declaration =
        "uniform float a[4]; uniform float other; struct S { vec2 v[3]; }; uniform S s[2];";
    const GLuint from = makeProgram(declaration, "a[3] + other + s[1].v[2].x");
    const GLuint to = makeProgram(declaration, "a[0] + 2.0 * a[1] + s[1].v[1].x + s[1].v[2].x");
    const GLuint wide = makeProgram(declaration, "a[0] + 2.0 * a[1] + a[2] + a[3] + s[1].v[2].x");
    std::array<float, 4> values{};
    std::iota(values.begin(), values.end(), 1.0f);
    gl().ProgramUniform1fv(from, gl().GetUniformLocation(from, "a"), 4, values.data());
    gl().ProgramUniform2f(from, gl().GetUniformLocation(from, "s[1].v[2]"), 100.0f, 0.0f);
    embed::SnippetUniforms uniforms;
    uniforms.copy(gl(), from, to);
    EXPECT_EQ(run(to), 105.0);
    uniforms.copy(gl(), to, wide);
    uniforms.copy(gl(), from, wide);
    EXPECT_EQ(run(wide), 112.0);
    // A pair that is known takes new values.
    gl().ProgramUniform1f(from, gl().GetUniformLocation(from, "a"), 10.0f);
    uniforms.copy(gl(), from, to);
    EXPECT_EQ(run(to), 114.0);
}

TEST_P(SnippetUniformsTest, oursStay) {
    const std::string declaration = "uniform float polylumeHere; uniform float there;";
    const GLuint from = makeProgram(declaration, "polylumeHere + there");
    const GLuint to = makeProgram(declaration, "polylumeHere + there");
    gl().ProgramUniform1f(from, gl().GetUniformLocation(from, "polylumeHere"), 1.0f);
    gl().ProgramUniform1f(from, gl().GetUniformLocation(from, "there"), 2.0f);
    embed::SnippetUniforms().copy(gl(), from, to);
    EXPECT_EQ(run(to), 2.0);
}

POLYLUME_ON_EVERY_BACKEND(SnippetUniformsTest);

}  // namespace
}  // namespace polylume
