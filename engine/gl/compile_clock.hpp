// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <chrono>

namespace polylume::gl {

/// Sums up how long programs take to be compiled. For one thread.
class CompileClock {
  public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(total_).count();
    }

    /// Adds the time of its life.
    class Scope {
      public:
        explicit Scope(CompileClock& clock)
            : clock_(clock), begin_(std::chrono::steady_clock::now()) {}
        ~Scope() { clock_.total_ += std::chrono::steady_clock::now() - begin_; }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        CompileClock& clock_;
        const std::chrono::steady_clock::time_point begin_;
    };

  private:
    std::chrono::steady_clock::duration total_{0};
};

}  // namespace polylume::gl
