// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <csignal>

namespace polylume::cli {

/// While it lives, the first SIGINT or SIGTERM is kept for the program to ask about; the next one
/// ends the process as ever. One at a time. A signal that the process was told to ignore stays so.
class StopSignal {
  public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// Whether one has come. May be asked from any thread.
    bool hasCome() const;

  private:
    struct sigaction interruptBefore_ {};
    struct sigaction terminateBefore_ {};
};

}  // namespace polylume::cli
