// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "embed/own_framebuffer.hpp"

#include <array>
#include <atomic>
#include <string_view>

#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::embed {
namespace {

std::string nextLabel() {
    static std::atomic<unsigned long> count = 0;
    return concat("polylume target ", ++count);
}

GLuint make(const gl::Functions& gl, const std::string& label) {
    GLuint name = 0;
    gl.CreateFramebuffers(1, &name);
    gl.ObjectLabel(GL_FRAMEBUFFER, name, -1, label.c_str());
    return name;
}

}  // namespace

OwnFramebuffer::OwnFramebuffer(const gl::Functions& gl)
    : label_(nextLabel()), handle_(gl, make(gl, label_)) {}

void OwnFramebuffer::checkContext() const {
    const gl::Functions& gl = handle_.functions();
    // Without a context every function returns 0. Another one may have this name for its own.
    if (gl.IsFramebuffer(name()) == GL_TRUE) {
        std::array<char, 64> found{};
        GLsizei length = 0;
        gl.GetObjectLabel(GL_FRAMEBUFFER, name(), static_cast<GLsizei>(found.size()), &length,
                          found.data());
        if (std::string_view(found.data(), static_cast<std::size_t>(length)) == label_) return;
    }
    throw Error(
        "expected a call of an AreaLighting in the context that it was made in, found another or "
        "none: the context that it was made in must be current in this thread");
}

}  // namespace polylume::embed
