// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <array>
#include <cstddef>

#include "context/thread_context.hpp"

namespace polylume::context {

struct OsmesaLibrary;

/// A context of libOSMesa, Mesa's software renderer that draws to memory.
class OsmesaContext final : public ThreadContext {
  public:
    /// Throws Error where the library is missing or too old, ContextError with the step that
    /// failed.
    OsmesaContext();
    ~OsmesaContext() override;

    static constexpr const char* kName = "OSMesa";

  private:
    void bind() override;
    void unbind() noexcept override;

    const OsmesaLibrary& osmesa_;
    void* context_ = nullptr;
    /// The default framebuffer, which OSMesa wants and nothing draws to.
    static constexpr int kBufferSize = 4;
    alignas(16) std::array<unsigned char, std::size_t{kBufferSize} * kBufferSize * 4> buffer_{};
};

}  // namespace polylume::context
