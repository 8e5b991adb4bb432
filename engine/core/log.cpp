// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "core/log.hpp"

#include <mutex>
#include <utility>

namespace polylume {
namespace {

LogSink& currentSink() {
    static LogSink sink;
    return sink;
}

}  // namespace

void setLogSink(LogSink sink) {
    currentSink() = std::move(sink);
}

void log(LogLevel level, std::string_view message) {
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    if (currentSink()) currentSink()(level, message);
}

}  // namespace polylume
