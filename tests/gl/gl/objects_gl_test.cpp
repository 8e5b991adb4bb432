// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/objects.hpp"

#include <gmock/gmock.h>

#include <array>

#include "gl/support/gl_test.hpp"

namespace polylume {
namespace {

class ObjectsTest : public test::GlTest {};

TEST_P(ObjectsTest, bufferHoldsWhatItWasGiven) {
    const std::array<float, 3> values = {1.0f, -2.0f, 3.5f};
    gl::Buffer buffer(gl(), gl::bytesOf(values), GL_DYNAMIC_STORAGE_BIT, "values");
    const float changed = 7.0f;
    buffer.update(gl::bytesOf(changed), sizeof(float));
    std::array<float, 3> read{};
    gl().GetNamedBufferSubData(buffer.name(), 0, sizeof(read), read.data());
    EXPECT_THAT(read, ::testing::ElementsAre(1.0f, 7.0f, 3.5f));
}

TEST_P(ObjectsTest, emptyBufferCanBeBound) {
    const gl::Buffer buffer(gl(), {}, 0, "nothing");
    gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.name());
    EXPECT_EQ(buffer.sizeBytes(), 1u);
}

TEST_P(ObjectsTest, textureReadsBackWhatWasUploaded) {
    gl::Texture texture(gl(), GL_RGBA32F, {2, 1}, 1, "two texels");
    const std::array<float, 8> texels = {0.1f, 0.2f, 0.3f, 0.4f, -1.0f, 1e20f, 0.0f, 1.0f};
    texture.upload(GL_RGBA, GL_FLOAT, texels.data());
    std::array<float, 8> read{};
    texture.read(GL_RGBA, GL_FLOAT, std::as_writable_bytes(std::span(read)));
    EXPECT_EQ(read, texels);
}

TEST_P(ObjectsTest, movedHandleLeavesNothingBehind) {
    gl::Texture first(gl(), GL_R8, {1, 1}, 1, "first");
    const GLuint name = first.name();
    const gl::Texture second = std::move(first);
    EXPECT_EQ(second.name(), name);
    EXPECT_EQ(first.name(), 0u);
}

TEST_P(ObjectsTest, incompleteFramebufferSaysWhichAndWhy) {
    // A colour format where depth belongs.
    const gl::Texture texture(gl(), GL_RGBA8, {4, 4}, 1, "colour");
    const std::array attachments = {gl::Framebuffer::Attachment{GL_DEPTH_ATTACHMENT, &texture}};
    try {
        const gl::Framebuffer framebuffer(gl(), attachments, "wrong depth");
        FAIL() << "expected an Error";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr("framebuffer \"wrong depth\" of 4x4"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("incomplete"));
    }
    // Mesa calls the attachment itself an error, too; it is expected here.
    try {
        context().debugLog().checkNoErrors("");
    } catch (const Error&) {
    }
}

TEST_P(ObjectsTest, debugLogThrowsWhatOpenGlReports) {
    gl().Enable(0xFFFF);
    try {
        context().debugLog().checkNoErrors("enabling nonsense");
        FAIL() << "expected an Error";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), ::testing::StartsWith("enabling nonsense: OpenGL error"));
        EXPECT_THAT(error.what(), ::testing::HasSubstr("glEnable"));
    }
    EXPECT_NO_THROW(context().debugLog().checkNoErrors("afterwards"));
}

POLYLUME_ON_EVERY_BACKEND(ObjectsTest);

}  // namespace
}  // namespace polylume
