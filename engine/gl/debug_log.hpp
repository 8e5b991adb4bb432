// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gl/functions.hpp"

namespace polylume::gl {

/// Records the KHR_debug messages of a context. Errors are kept until checkNoErrors() throws them;
/// everything of lower severity goes to the log at debug level.
class DebugLog {
  public:
    /// Installs the callback in the current context, which has to outlive this object.
    explicit DebugLog(const Functions& gl);
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    /// Throws Error that begins with `where` and lists every error since the last call, also one
    /// that glGetError reports alone.
    void checkNoErrors(std::string_view where);

  private:
    static void GLAPIENTRY record(GLenum source, GLenum type, GLuint id, GLenum severity,
                                  GLsizei length, const GLchar* message, const void* self);

    const Functions& gl_;
    std::vector<std::string> errors_;
};

}  // namespace polylume::gl
