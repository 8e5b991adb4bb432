// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#include "cli/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "polylume/error.hpp"

namespace polylume::cli {

namespace {

bool isQuiet = false;

}  // namespace

void logToStandardError(LogLevel level) {
    isQuiet = level == LogLevel::warning;
    setLogSink([level](LogLevel messageLevel, std::string_view message) {
        if (messageLevel > level) return;
        fmt::print(stderr, "polylume: {}{}\n", messageLevel == LogLevel::warning ? "warning: " : "",
                   message);
    });
}

void printReport(const std::string& text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0) {
        throw Error(
            fmt::format("can't write the report to standard output: {}", std::strerror(errno)));
    }
}

ProgressBar::ProgressBar(std::string title)
    : title_(std::move(title)),
      start_(std::chrono::steady_clock::now()),
      mayShow_(!isQuiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    // Leaves the line empty for what comes next.
    if (shown_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::update(double fraction) {
    constexpr std::chrono::seconds kPatience{2};
    constexpr int kWidth = 40;
    const auto elapsed = std::chrono::steady_clock::now() - start_;
    if (!mayShow_ || elapsed < kPatience) return;
    shown_ = true;
    const int filled = static_cast<int>(fraction * kWidth);
    const double seconds = std::chrono::duration<double>(elapsed).count();
    const double left = fraction > 0.0 ? seconds * (1.0 - fraction) / fraction : 0.0;
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %, {:.0f} s left\x1b[K", title_, "", filled,
               "", kWidth - filled, 100.0 * fraction, left);
    std::fflush(stderr);
}

}  // namespace polylume::cli
