// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <functional>
#include <string_view>

namespace polylume {

/// In the order of importance: a sink that shows `info` shows `warning` too.
enum class LogLevel { warning, info, debug };

using LogSink = std::function<void(LogLevel, std::string_view)>;

/// Sends every later message to `sink`; an empty one drops them, which is the default, so that a
/// host program hears nothing it did not ask for. Not to be called while other threads log.
void setLogSink(LogSink sink);

/// Hands one message, without a line end, to the sink. Safe to call from several threads at once.
void log(LogLevel level, std::string_view message);

}  // namespace polylume
