// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gl/debug_log.hpp"
#include "gl/functions.hpp"

namespace polylume {

enum class Backend { automatic, egl, osmesa };

/// What a context says of itself.
struct ContextInfo {
    std::string backend;  ///< "EGL device 0 (hardware)", "EGL surfaceless", "OSMesa", ...
    std::string vendor;
    std::string renderer;
    std::string version;
    std::string shadingLanguageVersion;
    bool software = false;  ///< Runs on the CPU.
};

/// A headless OpenGL 4.5 core context, current in the thread that made it.
class Context {
  public:
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    virtual void makeCurrent() = 0;

    const gl::Functions& functions() const { return functions_; }
    const ContextInfo& info() const { return info_; }
    gl::DebugLog& debugLog() { return *debugLog_; }

    /// Makes a context of the wanted backend and makes it current. `automatic` takes the first that
    /// works of: EGL on a hardware device, EGL on a software device or the surfaceless platform,
    /// OSMesa. Throws ContextError that lists each attempt, why it failed, and what to install.
    static std::unique_ptr<Context> create(Backend backend);

  protected:
    Context() = default;

    gl::Functions functions_{};
    ContextInfo info_;
    std::unique_ptr<gl::DebugLog> debugLog_;
};

/// One way to a context and what became of it, for `polylume info`.
struct ContextAttempt {
    std::string name;     ///< As ContextInfo::backend.
    std::string failure;  ///< Why it can't be had; empty where it can.
    ContextInfo info;     ///< Where it can.
    std::vector<std::pair<std::string, std::string>>
        limits;  ///< Name and value of the limits we rely on.
};

/// Tries every way there is. Leaves no context current.
std::vector<ContextAttempt> probeContexts();

}  // namespace polylume
