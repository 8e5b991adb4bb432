// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <tbb/task_arena.h>

#include <cstddef>
#include <mutex>

#include "core/progress.hpp"

namespace polylume {

/// An arena of at most `threadCount` threads; 0: one per processor, which is the most in any case.
tbb::task_arena makeArena(int threadCount);

/// What `work` returns, run with at most `threadCount` threads; 0: one per processor.
template <typename Work>
auto runOnThreads(int threadCount, const Work& work) {
    tbb::task_arena arena = makeArena(threadCount);
    return arena.execute(work);
}

/// Adds up the steps of several threads for a Progress.
class StepCounter {
  public:
    StepCounter(Progress& progress, std::size_t stepCount)
        : progress_(progress), stepCount_(stepCount) {}

    void step();

  private:
    Progress& progress_;
    std::size_t stepCount_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

}  // namespace polylume
