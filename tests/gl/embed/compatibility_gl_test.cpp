// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>

#include <algorithm>

#include "context/egl_library.hpp"
#include "context/thread_context.hpp"
#include "embed_fixture.hpp"
#include "host_state.hpp"

namespace polylume {
namespace {

using context::EglLibrary;
using test::differences;
using test::HostPicture;
using test::makeEveryLight;
using test::readPixels;

constexpr GLenum kAlphaTest = 0x0BC0;
constexpr GLenum kPolygonStipple = 0x0B42;
constexpr GLenum kClampFragmentColor = 0x891B;

/// A context of the compatibility profile, current from its making to its end.
class CompatibilityContext {
  public:
    CompatibilityContext() : egl_(EglLibrary::get()) {
        context::ThreadContext::releaseCurrent();
        const std::vector<EglLibrary::Place> places = egl_.places();
        const auto place = std::ranges::find(places, "EGL surfaceless", &EglLibrary::Place::name);
        if (place == places.end()) throw ContextError("no surfaceless platform");
        display_ = egl_.openDisplay(*place);
        egl_.bindApi(EGL_OPENGL_API);
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                     4,
                                     EGL_CONTEXT_MINOR_VERSION_KHR,
                                     5,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                     EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT_KHR,
                                     EGL_NONE};
        context_ = egl_.createContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context_ == EGL_NO_CONTEXT)
            throw ContextError(egl_.describeFailure("eglCreateContext"));
        egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
        gladLoadGLContext(&gl_, egl_.getProcAddress);
    }
    ~CompatibilityContext() {
        egl_.makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_.destroyContext(display_, context_);
    }
    CompatibilityContext(const CompatibilityContext&) = delete;
    CompatibilityContext& operator=(const CompatibilityContext&) = delete;

    const gl::Functions& gl() const { return gl_; }

  private:
    const EglLibrary& egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    gl::Functions gl_{};
};

TEST(CompatibilityProfileTest, itsOldStateHasNoSayAndStays) {
    const CompatibilityContext own;
    const gl::Functions& gl = own.gl();
    const HostPicture picture(gl);
    AreaLighting lighting(test::getProcAddressOf(Backend::egl));
    lighting.setLights(makeEveryLight());
    const gl::Texture plain = test::makeTarget(gl, picture.size(), glm::vec4(-1.0f));
    const gl::Texture odd = test::makeTarget(gl, picture.size(), glm::vec4(-1.0f));
    lighting.draw(picture.frame(plain));

    // An alpha test that nothing passes, a pattern of nothing, colours up to 1.
    const auto alphaFunc = reinterpret_cast<void (*)(GLenum, GLfloat)>(
        EglLibrary::get().getProcAddress("glAlphaFunc"));
    const auto polygonStipple = reinterpret_cast<void (*)(const GLubyte*)>(
        EglLibrary::get().getProcAddress("glPolygonStipple"));
    const std::array<GLubyte, 128> pattern{};
    alphaFunc(GL_NEVER, 0.0f);
    polygonStipple(pattern.data());
    gl.Enable(kAlphaTest);
    gl.Enable(kPolygonStipple);
    gl.ClampColor(kClampFragmentColor, GL_TRUE);
    ASSERT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    const test::StateTable before = test::readState(gl);
    lighting.draw(picture.frame(odd));
    lighting.setLights(makeEveryLight());
    EXPECT_THAT(differences(before, test::readState(gl)), testing::IsEmpty());
    EXPECT_EQ(gl.IsEnabled(kAlphaTest), GL_TRUE);
    EXPECT_EQ(gl.IsEnabled(kPolygonStipple), GL_TRUE);
    GLint clamp = 0;
    gl.GetIntegerv(kClampFragmentColor, &clamp);
    EXPECT_EQ(clamp, GL_TRUE);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));

    const auto wanted = readPixels(plain);
    EXPECT_EQ(readPixels(odd), wanted);
    EXPECT_GT(std::ranges::max(wanted, {}, [](const glm::vec4& p) { return p.r; }).r, 1.0f);
}

}  // namespace
}  // namespace polylume
