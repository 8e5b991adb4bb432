// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "gl/debug_log.hpp"

#include "core/log.hpp"
#include "core/text.hpp"
#include "polylume/error.hpp"

namespace polylume::gl {

DebugLog::DebugLog(const Functions& gl) : gl_(gl) {
    gl_.Enable(GL_DEBUG_OUTPUT);
    // Synchronous: the message arrives inside the call that caused it, so a debugger's stack shows
    // it.
    gl_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl_.DebugMessageCallback(&DebugLog::record, this);
    gl_.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    // Our own push and pop of groups say nothing new.
    gl_.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_PUSH_GROUP, GL_DONT_CARE, 0, nullptr,
                            GL_FALSE);
    gl_.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_POP_GROUP, GL_DONT_CARE, 0, nullptr,
                            GL_FALSE);
}

DebugLog::~DebugLog() {
    gl_.DebugMessageCallback(nullptr, nullptr);
}

void DebugLog::checkNoErrors(std::string_view where) {
    for (GLenum error = gl_.GetError(); error != GL_NO_ERROR; error = gl_.GetError()) {
        // With debug output the same error has come as a message, which says more.
        if (errors_.empty()) errors_.push_back(concat("glGetError 0x", std::hex, error));
    }
    if (errors_.empty()) return;
    std::string text = concat(where, ": OpenGL error");
    for (const std::string& error : errors_) text += concat("\n  ", error);
    errors_.clear();
    throw Error(text);
}

void GLAPIENTRY DebugLog::record(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum /*severity*/,
                                 GLsizei length, const GLchar* message, const void* self) {
    const std::string text(message, static_cast<std::size_t>(length));
    if (type == GL_DEBUG_TYPE_ERROR) {
        auto* log = const_cast<DebugLog*>(static_cast<const DebugLog*>(self));
        constexpr std::size_t kMostErrors = 16;  // A loop that fails says the same each time.
        if (log->errors_.size() < kMostErrors) log->errors_.push_back(text);
    } else {
        polylume::log(LogLevel::debug, concat("OpenGL: ", text));
    }
}

}  // namespace polylume::gl
