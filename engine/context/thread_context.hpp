// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "context/context.hpp"

namespace polylume::context {

/// What the two backends share: loading the functions, and one context current at a time. libEGL
/// and libOSMesa may be two copies of Mesa over one libglapi, where each would take the other's
/// current context for its own, so the one before is always released by its own library first.
class ThreadContext : public Context {
  public:
    void makeCurrent() final;

    /// The calling thread's current context; null for none.
    static ThreadContext* current();
    /// Releases the calling thread's current context.
    static void releaseCurrent();

    /// Name and value of the limits that Polylume relies on. The context has to be current.
    std::vector<std::pair<std::string, std::string>> limits() const;

  protected:
    /// The address of the function `name`, for the context that is current.
    using GetFunction = void (*(*)(const char* name))();

    /// Binds the context to the calling thread. Throws ContextError.
    virtual void bind() = 0;
    /// Leaves the calling thread without a context.
    virtual void unbind() noexcept = 0;

    /// For the end of a derived constructor: makes the context current, loads its functions, fills
    /// the info and starts the debug log. Throws ContextError for less than OpenGL 4.5 core.
    void start(const std::string& backend, GetFunction getFunction);
    /// For the destructor of the derived class, before it gives its context back: ends the debug
    /// log, releases the context and makes the one that was current before current again.
    void stop() noexcept;

  private:
    void loadFunctions(GetFunction getFunction);
};

}  // namespace polylume::context
