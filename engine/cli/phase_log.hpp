// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <chrono>
#include <string_view>

namespace polylume::cli {

/// Says in the log, at debug level, how long each phase of a command took and how much memory the
/// process has needed so far.
class PhaseLog {
  public:
    /// Ends the phase that began with the last call, or with this object.
    void finish(std::string_view phase);

  private:
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace polylume::cli
