// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <utility>

#include "gl/functions.hpp"

namespace polylume::gl {

/// Owns one OpenGL name, empty by default. `destroy` deletes it; the context that made it must be
/// current then, and outlive the handle.
template <void (*destroy)(const Functions&, GLuint)>
class Handle {
  public:
    Handle() = default;
    Handle(const Functions& gl, GLuint name) : gl_(&gl), name_(name) {}
    Handle(Handle&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) destroy(*gl_, name_);
    }

    GLuint name() const { return name_; }
    bool isEmpty() const { return name_ == 0; }
    /// Of a handle that is not empty.
    const Functions& functions() const { return *gl_; }

  private:
    const Functions* gl_ = nullptr;
    GLuint name_ = 0;
};

}  // namespace polylume::gl
