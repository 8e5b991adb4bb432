// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "context/context.hpp"
#include "polylume/error.hpp"

namespace polylume {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr int kNoContext = 7;

/// Ends the program after it has tried to make a context where `variable` keeps the driver from it.
/// For a child process only, as drivers read their environment once.
[[noreturn]] void exitWithFailureOf(Backend backend, const char* variable, const char* value) {
    ::setenv(variable, value, 1);
    try {
        Context::create(backend);
    } catch (const ContextError& error) {
        std::fputs(error.what(), stderr);
        std::exit(kNoContext);
    }
    std::exit(0);
}

class ContextFailureTest : public ::testing::Test {
  protected:
    // Begins the child anew, where no driver has been opened yet.
    ContextFailureTest() { GTEST_FLAG_SET(death_test_style, "threadsafe"); }
};

TEST_F(ContextFailureTest, listsEachAttemptWithWhatWasFoundAndWhatToInstall) {
    // Mesa's own switch: every driver of it then offers OpenGL 3.3.
    EXPECT_EXIT(exitWithFailureOf(Backend::automatic, "MESA_GL_VERSION_OVERRIDE", "3.3"),
                ::testing::ExitedWithCode(kNoContext),
                AllOf(HasSubstr("EGL surfaceless: expected OpenGL 4.5, found 3.3"),
                      HasSubstr("OSMesa: expected OpenGL 4.5, found 3.3"),
                      HasSubstr("libegl1 libegl-mesa0 libgl1-mesa-dri"), HasSubstr("libosmesa6")));
}

TEST_F(ContextFailureTest, saysThatEglLacksADriver) {
    // The variable of libglvnd's libEGL that names its drivers.
    EXPECT_EXIT(exitWithFailureOf(Backend::egl, "__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent"),
                ::testing::ExitedWithCode(kNoContext),
                AllOf(HasSubstr("neither a device nor the surfaceless platform"),
                      HasSubstr("libegl-mesa0"), ::testing::Not(HasSubstr("osmesa"))));
}

TEST_F(ContextFailureTest, automaticFallsBackToOsmesa) {
    EXPECT_EXIT(
        {
            ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
            std::fputs(Context::create(Backend::automatic)->info().backend.c_str(), stderr);
            std::exit(0);
        },
        ::testing::ExitedWithCode(0), "OSMesa");
}

}  // namespace
}  // namespace polylume
