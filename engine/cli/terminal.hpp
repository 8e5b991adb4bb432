// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <chrono>
#include <string>

#include "core/log.hpp"
#include "core/progress.hpp"

namespace polylume::cli {

/// Sends log messages up to `level` to standard error, one line each.
void logToStandardError(LogLevel level);

/// Writes a report to standard output. Throws Error where it is lost, on a full disk or a closed
/// pipe: that must not count as a success.
void printReport(const std::string& text);

/// A progress bar on standard error, where that is a terminal and the log level is not `warning`,
/// once the work has taken two seconds.
class ProgressBar : public Progress {
  public:
    explicit ProgressBar(std::string title);
    ~ProgressBar() override;

    void update(double fraction) override;

  private:
    std::string title_;
    std::chrono::steady_clock::time_point start_;
    bool mayShow_;
    bool shown_ = false;
};

}  // namespace polylume::cli
