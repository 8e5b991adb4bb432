// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "context/context.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>
#include <vector>

#include "context/thread_context.hpp"
#include "gl/support/gl_test.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr int kSize = 16;
using Pixels = std::vector<float>;

/// Four floats per pixel of a triangle over the whole picture, coloured by its position. It takes a
/// program, a draw and a read back, so it shows that the context works, and on which bits.
Pixels drawGradient(const gl::Functions& gl) {
    const char* vertexSource = R"(#version 450 core
        out vec2 place;
        void main() {
            place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
            gl_Position = vec4(place, 0.0, 1.0);
        })";
    const char* fragmentSource = R"(#version 450 core
        in vec2 place;
        out vec4 color;
        void main() { color = vec4(sin(place * 3.0), exp(place.x), inversesqrt(2.0 + place.y)); })";
    const GLuint program = gl.CreateProgram();
    for (const auto& [type, source] : {std::pair{GLenum{GL_VERTEX_SHADER}, vertexSource},
                                       std::pair{GLenum{GL_FRAGMENT_SHADER}, fragmentSource}}) {
        const GLuint shader = gl.CreateShader(type);
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);

    GLuint texture = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, GL_RGBA32F, kSize, kSize);
    GLuint framebuffer = 0;
    gl.CreateFramebuffers(1, &framebuffer);
    gl.NamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
    GLuint vertexArray = 0;
    gl.CreateVertexArrays(1, &vertexArray);

    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.Viewport(0, 0, kSize, kSize);
    gl.UseProgram(program);
    gl.BindVertexArray(vertexArray);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    Pixels pixels(std::size_t{kSize} * kSize * 4);
    gl.GetTextureImage(texture, 0, GL_RGBA, GL_FLOAT,
                       static_cast<GLsizei>(pixels.size() * sizeof(float)), pixels.data());

    gl.UseProgram(0);
    gl.BindVertexArray(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteVertexArrays(1, &vertexArray);
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteTextures(1, &texture);
    gl.DeleteProgram(program);
    return pixels;
}

/// One value of an 8-bit clear, read back.
std::array<unsigned char, 4> clearAndRead(const gl::Functions& gl, std::array<float, 4> color) {
    GLuint texture = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, GL_RGBA8, 1, 1);
    gl.ClearTexImage(texture, 0, GL_RGBA, GL_FLOAT, color.data());
    std::array<unsigned char, 4> pixel{};
    gl.GetTextureImage(texture, 0, GL_RGBA, GL_UNSIGNED_BYTE, 4, pixel.data());
    gl.DeleteTextures(1, &texture);
    return pixel;
}

class ContextTest : public test::GlTest {};

TEST_P(ContextTest, isOpenGl45CoreAndSaysWhatItIs) {
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    gl().GetIntegerv(GL_MAJOR_VERSION, &major);
    gl().GetIntegerv(GL_MINOR_VERSION, &minor);
    gl().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(major * 10 + minor, 45);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);

    const ContextInfo& info = context().info();
    EXPECT_THAT(info.backend, StartsWith(GetParam() == Backend::egl ? "EGL" : "OSMesa"));
    EXPECT_FALSE(info.vendor.empty());
    EXPECT_FALSE(info.renderer.empty());
    EXPECT_FALSE(info.version.empty());
    EXPECT_FALSE(info.shadingLanguageVersion.empty());
    EXPECT_EQ(info.software, info.renderer.find("llvmpipe") != std::string::npos);
}

TEST_P(ContextTest, clearsToTheExactValue) {
    EXPECT_EQ(clearAndRead(gl(), {1.0f, 0.0f, 128.0f / 255.0f, 1.0f}),
              (std::array<unsigned char, 4>{255, 0, 128, 255}));
}

TEST_P(ContextTest, drawsEveryPixel) {
    const Pixels pixels = drawGradient(gl());
    // exp(x) is positive wherever the triangle was drawn.
    for (std::size_t pixel = 0; pixel < pixels.size(); pixel += 4) {
        ASSERT_GT(pixels[pixel + 2], 0.0f) << "pixel " << pixel / 4;
    }
}

TEST_P(ContextTest, debugLogThrowsEachErrorOnce) {
    EXPECT_NO_THROW(context().debugLog().checkNoErrors("before"));
    gl().Enable(0xFFFF);
    try {
        context().debugLog().checkNoErrors("the broken call");
        FAIL() << "an error went unseen";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr("the broken call"));
        EXPECT_THAT(error.what(), HasSubstr("ENUM"));
    }
    EXPECT_NO_THROW(context().debugLog().checkNoErrors("after"));
}

TEST_P(ContextTest, aSecondContextSharesNothingAndLeavesTheFirstCurrent) {
    GLuint texture = 0;
    gl().CreateTextures(GL_TEXTURE_2D, 1, &texture);
    {
        const std::unique_ptr<Context> second = Context::create(GetParam());
        EXPECT_EQ(context::ThreadContext::current(), second.get());
        EXPECT_EQ(second->functions().IsTexture(texture), GL_FALSE);
        context().makeCurrent();
        EXPECT_EQ(gl().IsTexture(texture), GL_TRUE);
    }
    EXPECT_EQ(context::ThreadContext::current(), &context());
    EXPECT_EQ(gl().IsTexture(texture), GL_TRUE);
    gl().DeleteTextures(1, &texture);
}

TEST_P(ContextTest, worksInSeveralThreadsAtOnce) {
    const Pixels expected = drawGradient(gl());
    constexpr int kThreadCount = 4;
    std::array<Pixels, kThreadCount> found;
    std::vector<std::thread> threads;
    threads.reserve(kThreadCount);
    for (Pixels& pixels : found) {
        threads.emplace_back([&pixels, backend = GetParam()] {
            const std::unique_ptr<Context> own = Context::create(backend);
            pixels = drawGradient(own->functions());
            own->debugLog().checkNoErrors("in a thread");
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const Pixels& pixels : found) EXPECT_EQ(pixels, expected);
}

TEST_P(ContextTest, canBeMadeAndGivenBackManyTimes) {
    for (int round = 0; round < 20; ++round) {
        const std::unique_ptr<Context> made = Context::create(GetParam());
        ASSERT_EQ(clearAndRead(made->functions(), {0.0f, 1.0f, 0.0f, 1.0f})[1], 255);
    }
}

POLYLUME_ON_EVERY_BACKEND(ContextTest);

// Two copies of Mesa in one program: each has to see its own context only.
TEST(BothBackendsTest, takeTurnsInOneThread) {
    const std::unique_ptr<Context> egl = Context::create(Backend::egl);
    const std::unique_ptr<Context> osmesa = Context::create(Backend::osmesa);
    for (int round = 0; round < 3; ++round) {
        for (Context* context : {egl.get(), osmesa.get()}) {
            context->makeCurrent();
            const gl::Functions& gl = context->functions();
            EXPECT_EQ(reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)),
                      context->info().renderer);
            EXPECT_EQ(clearAndRead(gl, {0.0f, 0.0f, 1.0f, 1.0f})[2], 255);
            EXPECT_NO_THROW(context->debugLog().checkNoErrors("taking turns"));
        }
    }
}

TEST(BothBackendsTest, drawTheSameBitsOnTheSameRenderer) {
    const std::unique_ptr<Context> egl = Context::create(Backend::egl);
    const Pixels byEgl = drawGradient(egl->functions());
    const std::unique_ptr<Context> osmesa = Context::create(Backend::osmesa);
    const Pixels byOsmesa = drawGradient(osmesa->functions());
    if (egl->info().renderer != osmesa->info().renderer) {
        GTEST_SKIP() << "EGL gives " << egl->info().renderer;
    }
    EXPECT_EQ(byEgl, byOsmesa);
}

TEST(BothBackendsTest, areProbedAndLeaveNothingCurrent) {
    const std::vector<ContextAttempt> attempts = probeContexts();
    EXPECT_EQ(context::ThreadContext::current(), nullptr);
    int working = 0;
    for (const ContextAttempt& attempt : attempts) {
        if (!attempt.failure.empty()) continue;
        ++working;
        EXPECT_EQ(attempt.info.backend, attempt.name);
        const auto size =
            std::find_if(attempt.limits.begin(), attempt.limits.end(),
                         [](const auto& limit) { return limit.first == "texture size"; });
        ASSERT_NE(size, attempt.limits.end());
        EXPECT_GE(std::stoi(size->second), 16384);  // The least that OpenGL 4.5 allows.
    }
    EXPECT_GE(working, 2);
    EXPECT_EQ(attempts.back().name, "OSMesa");
}

TEST(BothBackendsTest, automaticTakesTheFirstThatWorks) {
    std::string expected;
    for (const ContextAttempt& attempt : probeContexts()) {
        if (expected.empty() && attempt.failure.empty()) expected = attempt.name;
    }
    EXPECT_EQ(Context::create(Backend::automatic)->info().backend, expected);
}

}  // namespace
}  // namespace polylume
