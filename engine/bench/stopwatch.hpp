// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <chrono>
#include <functional>

#include "context/context.hpp"

namespace polylume::bench {

enum class Clock {
    automatic,  ///< Timestamps of the GPU, or `wall` where the driver draws on the CPU.
    wall,       ///< From the first command until all work is done.
    /// CPU time of the process over the threads that a software driver draws with: what `wall`
    /// tells where nothing else runs, on a machine where much else does.
    processor
};

/// Times what OpenGL draws. The context outlives it and is current.
class Stopwatch {
  public:
    /// Throws Error for Clock::processor where a GPU draws.
    Stopwatch(const Context& context, Clock clock);
    ~Stopwatch();
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

    /// Seconds that the commands of `draw` take, with nothing before them under way. Waits.
    double seconds(const std::function<void()>& draw);

    const char* name() const;

  private:
    const gl::Functions& gl_;
    Clock clock_;  ///< `automatic` stands for timestamps.
    double threadCount_ = 1.0;
    GLuint queries_[2] = {};
};

}  // namespace polylume::bench
