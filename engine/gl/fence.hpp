// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <utility>

#include "gl/functions.hpp"

namespace polylume::gl {

/// A place in the commands that the GPU comes to in its time. Needs its context current.
class Fence {
  public:
    Fence() = default;
    /// After all commands so far.
    explicit Fence(const Functions& gl)
        : gl_(&gl), sync_(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {}
    Fence(Fence&& other) noexcept { *this = std::move(other); }
    Fence& operator=(Fence&& other) noexcept {
        std::swap(gl_, other.gl_);
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Fence() {
        if (sync_ != nullptr) gl_->DeleteSync(sync_);
    }

    bool isEmpty() const { return sync_ == nullptr; }
    /// Whether the GPU has come there. Does not wait.
    bool isSignaled() const {
        const GLenum status = gl_->ClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, 0);
        return status == GL_ALREADY_SIGNALED || status == GL_CONDITION_SATISFIED;
    }

  private:
    const Functions* gl_ = nullptr;
    GLsync sync_ = nullptr;
};

}  // namespace polylume::gl
