// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/program.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "gl/support/gl_test.hpp"

namespace polylume {
namespace {

class ProgramTest : public test::GlTest {
  protected:
    void SetUp() override {
        test::GlTest::SetUp();
        folder_ = std::filesystem::current_path() / ("program_test_" + std::to_string(::getpid()));
        std::filesystem::create_directories(folder_ / "passes");
    }
    void TearDown() override {
        std::filesystem::remove_all(folder_);
        test::GlTest::TearDown();
    }
    void write(const std::string& path, const std::string& text) {
        std::ofstream(folder_ / path) << text;
    }

    std::string errorOf(const std::string& fragmentPath) {
        try {
            const gl::ShaderLibrary library(folder_);
            const gl::Program program(gl(), library, "passes/fullscreen.vert", fragmentPath, {},
                                      "broken");
        } catch (const ShaderError& error) {
            drainErrors();
            return error.what();
        }
        return "no error";
    }

    /// What the driver reports by debug messages, too, is expected here.
    void drainErrors() {
        try {
            context().debugLog().checkNoErrors("");
        } catch (const Error&) {
        }
    }

    std::filesystem::path folder_;
};

TEST_P(ProgramTest, compileErrorNamesTheIncludedFileAndItsLine) {
    write("passes/part.glsl", "float good;\nfloat bad = vec3(1.0);\n");
    write("passes/broken.frag", "// one\n#include \"passes/part.glsl\"\nvoid main() {}\n");
    EXPECT_THAT(errorOf("passes/broken.frag"), ::testing::HasSubstr("passes/part.glsl:2("));
}

TEST_P(ProgramTest, compileErrorAfterAnIncludeHasTheRightLine) {
    write("passes/part.glsl", "float a;\nfloat b;\nfloat c;\n");
    write("passes/broken.frag",
          "// one\n#include \"passes/part.glsl\"\n// three\nvoid main() { nonsense; }\n");
    EXPECT_THAT(errorOf("passes/broken.frag"), ::testing::HasSubstr("passes/broken.frag:4("));
}

TEST_P(ProgramTest, linkErrorIsThrown) {
    write("passes/broken.frag",
          "in vec3 neverWritten;\nout vec4 c;\nvoid main() { c = vec4(neverWritten, 1.0); }\n");
    EXPECT_THAT(errorOf("passes/broken.frag"), ::testing::HasSubstr("do not link"));
}

TEST_P(ProgramTest, overriddenFileIsUsedAndTheRestIsBuiltIn) {
    write("passes/good.frag",
          "#include \"ltc/edge.glsl\"\nout vec4 c;\nvoid main() { c = vec4(ltcCrossZ(vec3(1), "
          "vec3(0))); }\n");
    EXPECT_EQ(errorOf("passes/good.frag"), "no error");
}

POLYLUME_ON_EVERY_BACKEND(ProgramTest);

}  // namespace
}  // namespace polylume
