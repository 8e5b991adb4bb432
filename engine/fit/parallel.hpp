// SPDX-FileCopyrightText: 2026 The Polylume authors
// SPDX-License-Identifier: MIT

#pragma once

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <mutex>

#include "core/progress.hpp"

namespace polylume::fit {

/// What `work` returns, run with at most `threadCount` threads; 0: one per processor.
template <typename Work>
auto runOnThreads(int threadCount, const Work& work) {
    // TBB warns on the terminal about more threads than processors.
    const int processorCount = tbb::info::default_concurrency();
    const int wantedCount = threadCount > 0 ? threadCount : processorCount;
    tbb::task_arena arena(std::min(wantedCount, processorCount));
    return arena.execute(work);
}

/// Adds up the steps of several threads for a Progress.
class StepCounter {
  public:
    StepCounter(Progress& progress, std::size_t stepCount)
        : progress_(progress), stepCount_(stepCount) {}

    void step() {
        const std::lock_guard lock(mutex_);
        ++done_;
        progress_.update(static_cast<double>(done_) / static_cast<double>(stepCount_));
    }

  private:
    Progress& progress_;
    std::size_t stepCount_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

}  // namespace polylume::fit
