// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "gl/objects.hpp"

namespace polylume {

/// Many uniform blocks of one kind in one buffer, of which one is bound at a time.
template <typename Block>
class BlockArray {
  public:
    BlockArray() = default;
    BlockArray(const gl::Functions& gl, const std::vector<Block>& blocks, const char* label)
        : gl_(&gl) {
        GLint alignment = 1;
        gl.GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
        const auto unit = static_cast<std::size_t>(alignment);
        stride_ = (sizeof(Block) + unit - 1) / unit * unit;
        std::vector<std::byte> bytes(blocks.size() * stride_);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            std::memcpy(bytes.data() + i * stride_, &blocks[i], sizeof(Block));
        }
        buffer_ = gl::Buffer(gl, bytes, 0, label);
    }

    void bind(GLuint binding, int index) const {
        gl_->BindBufferRange(GL_UNIFORM_BUFFER, binding, buffer_.name(),
                             static_cast<GLintptr>(stride_) * index, sizeof(Block));
    }

  private:
    const gl::Functions* gl_ = nullptr;
    gl::Buffer buffer_;
    std::size_t stride_ = 0;
};

}  // namespace polylume
